// EffectCull.h - one effect in one cull traversal: what a technique fetches once and hands down.
#pragma once

namespace osgUtil {
class CullVisitor;
}

namespace osgFbrdf {

class EffectInternals;
class FactorizedBrdf;
class ViewState;

struct EffectCull {
    osgUtil::CullVisitor& visitor;
    ViewState& view;
    FactorizedBrdf& effect;
    EffectInternals& internals;
};

}  // namespace osgFbrdf

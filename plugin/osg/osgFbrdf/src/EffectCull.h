// EffectCull.h - one effect in one cull traversal: what a technique fetches once and hands down.
#pragma once

namespace osg {
class StateSet;
}
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

/// Culls the children of the effect once, under the state of a pass and what changes with the
/// frame.
void cullUnder(const EffectCull& cull, osg::StateSet* state, osg::StateSet* varying);

}  // namespace osgFbrdf

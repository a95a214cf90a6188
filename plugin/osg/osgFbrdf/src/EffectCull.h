// EffectCull.h - one effect in one cull traversal: what a technique fetches once and hands down.
#pragma once
#include <osgFX/Technique>

#include <functional>

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

/// The reason of an effect without one.
constexpr const char* kNoMaterial = "no material";

struct EffectCull {
    osgUtil::CullVisitor& visitor;
    ViewState& view;
    FactorizedBrdf& effect;  ///< has the material and the properties
    EffectInternals& internals;
    const FactorizedBrdf& model;  ///< what is drawn is below it
    /// Culls that under the state that the visitor has: to be called once for each pass.
    const std::function<void()>& cullModel;
    /// Culls what is blended, under the state of its only pass; null: it is drawn as the rest.
    const std::function<void()>& cullBlended;
    int selected = 0;  ///< the technique that is to draw, or AUTO_DETECT
};

/// A technique of the effect. FactorizedBrdf replaces the traversal of osgFX.
class EffectTechnique : public osgFX::Technique {
public:
    virtual void cull(const EffectCull& cull) = 0;

protected:
    void define_passes() override {}  // they depend on the scene
};

/// Culls the model once, under the state of a pass and what changes with the
/// frame.
void cullUnder(const EffectCull& cull, osg::StateSet* state, osg::StateSet* varying);

}  // namespace osgFbrdf

// PassTechnique.h - draws an effect by a plan of the runtime: each pass is a state set under which
// the children are culled once. Passes live in bins inside one bin, so that any number of them is
// drawn before what comes after the effect (OSG's bin 10 holds what is transparent).
#pragma once
#include "ContextNeeds.h"
#include "SceneLights.h"
#include "Surfaces.h"

#include <osgFbrdf/FactorizedBrdf.h>

#include <fbrdf/plan/Plan.h>

#include <osgFX/Technique>

#include <string>

namespace osgUtil {
class CullVisitor;
}

namespace osgFbrdf {

class PassTechnique : public osgFX::Technique {
public:
    PassTechnique(FactorizedBrdf& effect, fbrdf::Technique kind);

    const char* techniqueName() override;
    const char* techniqueDescription() override;
    bool validate(osg::State& state) const override;
    void traverse(osg::NodeVisitor& visitor, osgFX::Effect* effect) override;

    ContextNeeds needs() const;
    /// The plan for so many lights, or its reason for being none. offscreen: Surfaces can be used.
    /// laws: some lights have one (PlainLights.h).
    fbrdf::Plan plan(int lights, bool laws, bool offscreen) const;

protected:
    ~PassTechnique() override = default;
    void define_passes() override {}  // they depend on the lights: see traverse

private:
    struct Drawing {
        fbrdf::Plan plan;
        osg::ref_ptr<Surfaces> surfaces;  ///< null: the plan needs none
    };
    Drawing drawingOf(osgUtil::CullVisitor& visitor, const EyeLights& lights) const;
    int lightsInOnePass(const EyeLights& lights) const;
    /// fog: of the scene, null where there is none.
    void cullPasses(osgUtil::CullVisitor& visitor, const Drawing& drawing, EyeLights lights,
                    osg::StateSet* fog);
    /// False, with a refusal, where what is known of the context without asking OpenGL rules this
    /// technique out: before the first frame, or when it is forced.
    bool mayDraw(osg::State& state) const;
    void cull(osgUtil::CullVisitor& visitor);

    FactorizedBrdf& effect_;  ///< owns this
    fbrdf::Technique kind_;
};

}  // namespace osgFbrdf

// PassTechnique.h - draws an effect by a plan of the runtime: each pass is a state set under which
// the model is culled once. Passes are in bins inside one bin, so that any number of them is
// drawn before what comes after the effect (transparent objects are in OSG's bin 10).
#pragma once
#include "ContextNeeds.h"
#include "EffectCull.h"
#include "Illumination.h"
#include "MaterialStates.h"
#include "Surfaces.h"

#include <fbrdf/plan/Plan.h>

#include <memory>
#include <optional>

namespace osgFbrdf {

class InheritedState;

class PassTechnique : public EffectTechnique {
public:
    PassTechnique(FactorizedBrdf& effect, EffectInternals& internals, fbrdf::Technique kind);

    const char* techniqueName() override;
    const char* techniqueDescription() override;
    bool validate(osg::State& state) const override;
    void cull(const EffectCull& cull) override;

    ContextNeeds needs() const;

protected:
    ~PassTechnique() override = default;

private:
    struct Drawing {
        std::shared_ptr<const PlannedPasses> passes;
        osg::ref_ptr<Surfaces> surfaces;  ///< null: the plan needs none
        bool surfacesFailed = false;      ///< the plan does without them as there are none
    };
    /// offscreen: Surfaces can be used.
    fbrdf::PlanRequest request(int lights, bool offscreen, const EyeLobes& lobes) const;
    /// shadows: of which the units are left to the maps.
    TextureUnits textureUnits(const ReceivedShadows& shadows = {}) const;
    PassInputs inputs(const Illumination& light) const;

    /// False, with a refusal, where what is known of the context without asking OpenGL rules this
    /// technique out: before the first frame, or when it is forced.
    bool mayDraw(osg::State& state) const;
    Illumination illuminationOf(const EffectCull& cull, const InheritedState& inherited) const;
    /// The shadows that fall on the effect, as far as its maps leave texture units to them.
    ReceivedShadows shadowsOf(const EffectCull& cull, const InheritedState& inherited) const;
    /// Null where lights are culled by object.
    osg::ref_ptr<const LightLists> listsOf(const EffectCull& cull, const InheritedState& inherited,
                                           const ReceivedShadows& shadows) const;
    Drawing drawingOf(const EffectCull& cull, const Illumination& light) const;
    /// The same with fewer lights, where all are too many for the only pass that there can be.
    Drawing drawingOfMost(const EffectCull& cull, Illumination& light) const;
    /// Why it cannot be drawn; empty where it can.
    std::string reasonAgainst(const Drawing& drawing) const;
    int lightsInOnePass(const Illumination& light) const;
    /// The only pass of what is blended, of as many of the lights as it can have; null, with a
    /// reason, where there is none.
    std::shared_ptr<const PlannedPasses> blendedPass(Illumination& light,
                                                     std::string& whyNot) const;
    void cullBlended(const EffectCull& cull, const PlannedPasses& pass, const Illumination& light);
    /// fog: of the scene, null where there is none.
    void cullPasses(const EffectCull& cull, const Drawing& drawing, const Illumination& light,
                    osg::StateSet* fog);

    FactorizedBrdf& effect_;  ///< owns this
    EffectInternals& internals_;
    fbrdf::Technique kind_;
};

}  // namespace osgFbrdf

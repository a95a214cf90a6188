// FrameStates.h - what changes in the passes of an effect with frame and view: lights, environment,
// exposure, the eye. It is made anew each time, as the last one may still be being drawn.
#pragma once
#include "Illumination.h"
#include "ShadowPlacement.h"
#include "Surfaces.h"
#include "TextureUnits.h"

#include <fbrdf/plan/Plan.h>

#include <osg/StateSet>

#include <vector>

namespace osgFbrdf {

class FactorizedBrdf;

class FrameStates {
public:
    /// light: outlives this. surfaces: null where no pass reads one. shadows: null where no light
    /// has any.
    FrameStates(const FactorizedBrdf& effect, const osg::Matrixd& projection,
                const Illumination& light, Surfaces* surfaces, const TextureUnits& units,
                ShadowPlacement* shadows);

    /// The uniforms of the pass and the surface that it reads; MaterialStates has the rest.
    osg::ref_ptr<osg::StateSet> stateOf(const fbrdf::Pass& pass) const;

private:
    void addLights(osg::StateSet& state, const fbrdf::Pass& pass) const;
    void addShadowMaps(osg::StateSet& state) const;
    void addLists(osg::StateSet& state, const fbrdf::Pass& pass) const;
    void addLobes(osg::StateSet& state, const fbrdf::Pass& pass) const;
    void addSurface(osg::StateSet& state, fbrdf::Surface surface) const;

    const Illumination& light_;
    osg::ref_ptr<osg::Uniform> attenuations_;  ///< null: no light has one
    osg::ref_ptr<osg::Uniform> toEnvironment_, environmentScale_;
    osg::ref_ptr<Surfaces> surfaces_;
    const FactorizedBrdf& effect_;
    TextureUnits units_;
    osg::ref_ptr<osg::Uniform> eye_;
    std::vector<osg::ref_ptr<osg::Uniform>> scales_;
    osg::ref_ptr<ShadowPlacement> shadows_;
};

}  // namespace osgFbrdf

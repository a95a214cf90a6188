// EyeLights.h - the lights of one object in eye coordinates: those that are on and reach it.
#pragma once
#include "SceneLights.h"

#include <fbrdf/plan/LightSelection.h>

#include <vector>

namespace osgFbrdf {

class InheritedState;

struct EyeLights {
    std::vector<fbrdf::Light> lights;
    /// Which of the attenuations each light has; kNotAttenuated: its falloff and cone are the
    /// runtime's.
    std::vector<int> attenuationOf;
    std::vector<Attenuation> attenuations;  ///< at most kMostAttenuations
    int culled = 0;                         ///< lights that cannot reach the object
    int dropped = 0;                        ///< lights that are too many
};

/// False where a state set turns the mode GL_LIGHTn of the light off.
bool isOn(const PlacedOsgLight& source, const InheritedState& state);

/// The lights of PointLights, all of them.
std::vector<fbrdf::Light> pointLightsInEye(const SceneLights& scene, const osg::Matrixd& toEye);

/// The lights that are on; bounds: of the object, in eye coordinates. withSpare: the spare light of
/// the scene too, where there is one.
EyeLights lightsOf(const SceneLights& scene, const osg::Matrixd& toEye, const fbrdf::Sphere& bounds,
                   const InheritedState& state, bool withSpare = true);

/// The `most` lights that are the strongest on the object; most > 0.
EyeLights strongest(const EyeLights& lights, const fbrdf::Sphere& bounds, int most);

}  // namespace osgFbrdf

// Illumination.h - what lights one object, in eye coordinates, and the shadows that fall on it.
#pragma once
#include "EyeLights.h"
#include "EyeLobes.h"
#include "ShadowHook.h"

namespace osgFbrdf {

struct Illumination {
    fbrdf::Sphere bounds;  ///< of the object
    EyeLights lights;
    EyeLobes lobes;
    ReceivedShadows shadows;

    LightHooks hooks() const
    {
        return {!lights.attenuations.empty(), lights.lights.empty() ? ShadowMaps() : shadows.maps};
    }
};

}  // namespace osgFbrdf

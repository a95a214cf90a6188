// Lights.h - converts a light of the ABI into one of the planner.
#pragma once
#include "Boundary.h"

namespace fbrdf::capi {

/// Checks the type only, because draws drop and count lights that are not valid. Throws Failure.
inline Light lightOf(const fbrdf_light& light)
{
    Light result;
    result.type = enumerator(light.type, Light::Type::spot, "light type");
    for (int k = 0; k < 3; ++k) {
        result.position[k] = light.position[k];
        result.intensity[k] = light.intensity[k];
        result.axis[k] = light.axis[k];
    }
    result.radius = light.radius;
    result.innerAngle = light.inner_angle;
    result.outerAngle = light.outer_angle;
    return result;
}

}  // namespace fbrdf::capi

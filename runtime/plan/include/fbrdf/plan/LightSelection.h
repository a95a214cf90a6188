// LightSelection.h - which lights an object needs: those whose influence reaches its bounds, the
// strongest first, up to a limit. Pure.
#pragma once
#include <fbrdf/plan/AreaLight.h>
#include <fbrdf/plan/Light.h>

#include <vector>

namespace fbrdf {

struct Sphere {
    Vec3f centre{0.0f};
    float radius = 0.0f;  ///< >= 0
};

struct LightSelection {
    std::vector<int> lights;  ///< indices, strongest first
    int culled = 0;           ///< lights that cannot reach the bounds: nothing is lost
    int dropped = 0;          ///< lights that reach the bounds but exceed the limit
};

/// An upper bound of the irradiance (mean of the channels) that a valid light causes in the sphere:
/// its irradiance at the nearest point, as if that were inside its cone. 0 where the light's radius
/// ends before the sphere or its cone misses it.
double strongestIrradiance(const Light& light, const Sphere& bounds);
/// The same bound for the largest channel, at least 0.
double largestIrradiance(const Light& light, const Sphere& bounds);

/// The same bound for an area light: it is not stronger than the sphere around it would be. 0 where
/// its radius ends before the sphere or its plane is behind it.
double strongestIrradiance(const AreaLight& light, const Sphere& bounds);

/// Expects valid lights. most: the limit, or 0 for none; without a limit the order is that given.
LightSelection selectLights(const std::vector<Light>& lights, const Sphere& bounds, int most);
LightSelection selectLights(const std::vector<AreaLight>& lights, const Sphere& bounds, int most);

}  // namespace fbrdf

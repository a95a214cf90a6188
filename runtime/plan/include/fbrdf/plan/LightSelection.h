// LightSelection.h - which lights an object needs: those whose influence reaches its bounds, the
// strongest first, at most so many. Pure.
#pragma once
#include <fbrdf/plan/Light.h>

#include <vector>

namespace fbrdf {

struct Sphere {
    Vec3f centre{0.0f};
    float radius = 0.0f;  ///< >= 0
};

struct LightSelection {
    std::vector<int> lights;  ///< indices, strongest first
    int culled = 0;           ///< cannot reach the bounds: nothing is lost
    int dropped = 0;          ///< reach them, but there were too many
};

/// The largest irradiance (mean of the channels) that a valid light can cause in the sphere; an
/// upper bound: the nearest point, inside its cone. 0 where its
/// radius ends before, or its cone misses.
double strongestIrradiance(const Light& light, const Sphere& bounds);
/// The same of the largest channel.
double largestIrradiance(const Light& light, const Sphere& bounds);

/// lights: valid. most: 0 for no limit. Where there is no limit the order is that given.
LightSelection selectLights(const std::vector<Light>& lights, const Sphere& bounds, int most);

}  // namespace fbrdf

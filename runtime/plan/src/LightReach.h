// LightReach.h - where a light with a radius can be seen, in eye space.
#pragma once
#include <fbrdf/plan/LightVectors.h>

namespace fbrdf {

// Distances from the eye below count as this; far below any near plane, so that logs stay finite.
constexpr double kNearest = 1e-6;

/// A sphere that holds every point that a light with a radius reaches.
struct Reach {
    Vec3d centre{0.0};
    double radius = 0.0;
};
bool isUnlimited(const LightVectors& light);
double influenceRadius(const LightVectors& light);  ///< of a light with a radius
Reach reachOf(const LightVectors& light);           ///< of a light with a radius; less for a spot

}  // namespace fbrdf

// LightReach.h - where a light with a radius can be seen, in eye space.
#pragma once
#include <fbrdf/plan/LightVectors.h>

namespace fbrdf {

// The least distance from the eye: smaller ones count as this, so that logs stay finite. It is far
// below any near plane.
constexpr double kNearest = 1e-6;

/// A sphere around every point that a light with a radius reaches.
struct Reach {
    Vec3d centre{0.0};
    double radius = 0.0;
};
bool isUnlimited(const LightVectors& light);
/// Expects a light with a radius.
double influenceRadius(const LightVectors& light);
/// Expects a light with a radius. The sphere of a spot is smaller than its radius.
Reach reachOf(const LightVectors& light);

}  // namespace fbrdf

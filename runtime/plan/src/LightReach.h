// LightReach.h - where a light with a radius can be seen, in eye space.
#pragma once
#include <fbrdf/plan/LightVectors.h>

namespace fbrdf {

// The least distance from the eye: smaller ones count as this, so that logs stay finite. It is far
// below any near plane.
constexpr double kNearest = 1e-6;

/// Every point that a light with a radius reaches is in the sphere and in the cone.
struct Reach {
    Vec3d centre{0.0};
    double radius = 0.0;
    /// A unit axis, and cosine and sine of the angle between it and the side.
    Vec3d apex{0.0}, axis{0.0};
    double cosine = -1.0, sine = 0.0;
    bool hasCone() const { return cosine > -1.0; }
};
inline bool isUnlimited(const LightVectors& light)
{
    return light[0].w == 0.0f;
}
/// Expects a light with a radius.
double influenceRadius(const LightVectors& light);
/// Expects a light with a radius. The sphere of a spot is smaller than its radius.
Reach reachOf(const LightVectors& light);

}  // namespace fbrdf

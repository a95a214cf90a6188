// AreaVectors.h - area lights as programs take them : five vec4 in eye space,
//   [0]        the centre; w: 1 / radius^2, or 0 for an unlimited light. This vector alone decides
//              which points the light reaches, as that of LightVectors.h.
//   [1] - [4]  a, b, c, d as the kind says; w: radiance in red, green and blue, and
//              kind + 8 x number, where the host's shadow hook is told the number.
// A polygon is several of them, of three or four corners each: what two of them share cancels.
// Pure; renderers and engine plugins share it.
#pragma once
#include <fbrdf/plan/AreaLight.h>
#include <fbrdf/plan/LightVectors.h>

namespace fbrdf {

constexpr int kVectorsPerAreaLight = 5;
using AreaVectors = std::array<glm::vec4, kVectorsPerAreaLight>;

/// What a, b, c and d are.
enum class AreaKind {
    facet = 0,          ///< four corners of a convex polygon, counterclockwise; d may equal c
    twoSidedFacet = 1,  ///< the same
    disc = 2,           ///< the centre, and two perpendicular radii; shines along b x c
    twoSidedDisc = 3,   ///< the same
    sphere = 4,         ///< the centre; b.x: the radius
    tube = 5,           ///< both ends of the axis; c.x: the radius
};
constexpr int kAreaKinds = 8;  ///< what a number is multiplied by

/// Appends what stands for a valid light. number: below 2^20. toEye: world to eye, rigid. Computed
/// in double.
void appendAreaVectors(const AreaLight& light, int number, const glm::dmat4& toEye,
                       std::vector<AreaVectors>& vectors);

/// What lists of lights need of it (LightClusters.h): a point light of the same reach, or a spot in
/// front of a flat light that shines from one side.
LightVectors reachOf(const AreaVectors& light);

}  // namespace fbrdf

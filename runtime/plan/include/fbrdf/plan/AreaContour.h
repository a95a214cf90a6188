// AreaContour.h - the outline of an area light as a point sees it, and how much of a lobe is inside
// of it. Radiance is the same all over a light, so its outline is all that counts. The functions
// have twins in GLSL, step by step.
#pragma once
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/plan/AreaVectors.h>

namespace fbrdf {

/// Points of each arc of a tube's outline; a circle has one less in each half, 16 in all. Polygons
/// have the area of what is round.
constexpr int kArcPoints = 9;

/// Two arcs whose points, joined, are a convex outline. Point i of arc k is
///     centre + r (along cos a + across sin a),   a from -half to half in equal steps,
/// where r is 1 for the first and the last point and `bulge` for those between.
template <class T>
struct AreaContour {
    std::array<Vec3<T>, 2> centre, along, across;
    std::array<T, 2> half{}, bulge{};
    int points = 0;  ///< of each arc; 0: nothing is seen of the light
    /// The outline is a circle about this unit direction; squaredSine: of its angular radius, 0
    /// where it is none.
    Vec3<T> axis{T(0)};
    T squaredSine = T(0);
    bool isAround = false;  ///< the point is inside of the light
};

/// The outline of a light as seen from a point in the space of the light. Twin: fbrdfAreaContour.
template <class T>
AreaContour<T> areaContour(const AreaVectors& light, const Vec3<T>& point);

/// Point i of both arcs, 0 to 2 points - 1. Twin: fbrdfContourPoint.
template <class T>
Vec3<T> contourPoint(const AreaContour<T>& contour, int i);

/// The share of the lobe of a level about a unit axis that is inside of the outline and above the
/// horizon of the unit normal n: 0 to 1. Twin: fbrdfLobeInArea.
template <class T>
T lobeInArea(const AreaContour<T>& contour, const Vec3<T>& n, const Vec3<T>& axis, T level);

/// Radiance that leaves a point towards the direction whose lobes are given, in the frame of the
/// point, of one light: the sum of lobeInArea times weights, times radiance and window.
template <class T>
Vec3<T> areaReflected(const LobeSum<T>& lobes, const ShadingFrame<T>& frame,
                      const AreaVectors& light, const Vec3<T>& point);

}  // namespace fbrdf

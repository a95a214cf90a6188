// ClusterGeometry.h - what decides whether a light may reach a part of the view: intervals, the
// edges of tiles, a box against a cone. Eye space. Twins: cluster_geometry.glsl.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace fbrdf {

template <class T>
struct DistanceRange {
    T low = T(0), high = T(0);
};

template <class T>
T square(T x)
{
    return x * x;
}

/// How far x is outside of the interval; 0 inside. Twin: fbrdfIntervalDistance.
template <class T>
T intervalDistance(const DistanceRange<T>& interval, T x)
{
    return std::max(std::max(interval.low - x, x - interval.high), T(0));
}

/// The tile's coordinates between the ends of a slice, along one axis. lines: the edges of the
/// tiles are at lines.x + lines.y x edge at the near end of the slice, and at lines.z + lines.w x
/// edge at its far end. margin: of a tile, by which it is widened on either side. Twin:
/// fbrdfTileExtent.
template <class T>
DistanceRange<T> tileExtent(const glm::vec<4, T, glm::defaultp>& lines, T tile, T margin)
{
    const T first = tile - margin, last = tile + T(1) + margin;
    const T a = lines.x + lines.y * first, b = lines.x + lines.y * last,
            c = lines.z + lines.w * first, d = lines.z + lines.w * last;
    return {std::min(std::min(a, b), std::min(c, d)), std::max(std::max(a, b), std::max(c, d))};
}

/// True where a box is certain to be outside of a cone, from which its centre is seen along
/// toCentre; half: half of each side. cosine, sine: of the angle between the cone's axis, which is
/// unit, and its side, 0 to pi. Twin: fbrdfConeMissesBox.
//
// The function cosine x (distance from the axis) - sine x (way along it) is 0 on the side of the
// cone and above outside. Where the cosine is not negative it is at least the linear function
// of the same value and gradient at the centre, whose least value in the box is known; otherwise
// the distance from the axis grows by at most half of the diagonal.
template <class T>
bool coneMissesBox(const Vec3<T>& toCentre, const Vec3<T>& half, const Vec3<T>& axis, T cosine,
                   T sine)
{
    const T along = glm::dot(toCentre, axis), sineAlong = sine * along;
    const Vec3<T> across = toCentre - along * axis;
    const T distanceSquared = glm::dot(across, across);
    // The centre is inside: most often, and without a root.
    if (cosine >= T(0) && sineAlong >= T(0) &&
        square(cosine) * distanceSquared <= square(sineAlong))
        return false;
    const T distance = std::sqrt(distanceSquared);
    const Vec3<T> outwards =
        std::max(cosine, T(0)) / std::max(distance, T(1e-30)) * across - sine * axis;
    T extent = glm::dot(glm::abs(outwards), half);
    if (cosine < T(0)) extent -= cosine * glm::length(half);
    return cosine * distance - sineAlong > extent;
}

}  // namespace fbrdf

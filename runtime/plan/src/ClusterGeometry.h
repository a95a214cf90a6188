// ClusterGeometry.h - what decides whether a light may reach a part of the view: intervals, the
// edges of tiles, planes around a cone. Eye space. Twins: cluster_geometry.glsl.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
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

/// A half space, of all points p with dot(outwards, p) <= offset.
template <class T>
struct HalfSpace {
    Vec3<T> outwards;  ///< unit
    T offset;
};
constexpr int kConePlanes = 8;

/// Half spaces that all of a cone within `radius` of its apex is in. axis: unit; cosine, sine: of
/// the angle between it and the side, 0 to pi.
//
// Planes that touch a cone of up to 90 degrees have cosine x side - sine x axis outwards, for any
// unit side across the axis; the first side here is as near to the direction of x as there is one,
// so that two of eight planes bound the x of the cone. A wider cone is in front of a plane across
// the axis, since dot(axis, p) is at least cosine x radius there.
template <class T>
std::array<HalfSpace<T>, kConePlanes> conePlanes(const Vec3<T>& apex, T radius, const Vec3<T>& axis,
                                                 T cosine, T sine)
{
    constexpr T kDiagonal = T(0.70710678118654752);  // an eighth of a turn
    const Vec3<T> along = std::abs(axis.x) > T(0.999) ? Vec3<T>(0, 1, 0) : Vec3<T>(1, 0, 0);
    const Vec3<T> first = glm::normalize(along - glm::dot(along, axis) * axis),
                  second = glm::cross(axis, first);
    std::array<HalfSpace<T>, kConePlanes> planes;
    glm::vec<2, T, glm::defaultp> turn(1, 0);
    for (HalfSpace<T>& plane : planes) {
        plane.outwards =
            cosine < T(0) ? -axis : cosine * (turn.x * first + turn.y * second) - sine * axis;
        plane.offset = glm::dot(plane.outwards, apex) - std::min(cosine, T(0)) * radius;
        turn = {kDiagonal * (turn.x - turn.y), kDiagonal * (turn.x + turn.y)};
    }
    return planes;
}

// Planes that are more even bound no x.
template <class T>
constexpr T kEvenPlane = T(1e-6);

/// The x between which some of a cone, as of conePlanes, may be for y and distances -z in
/// intervals; low is above high where none is. slack: a length that is added to offsets. Twin:
/// fbrdfConeBounds.
template <class T>
DistanceRange<T> coneBounds(const Vec3<T>& apex, T radius, const Vec3<T>& axis, T cosine, T sine,
                            const DistanceRange<T>& y, const DistanceRange<T>& distance, T slack)
{
    DistanceRange<T> bounds{T(-1e30), T(1e30)};
    for (const HalfSpace<T>& plane : conePlanes(apex, radius, axis, cosine, sine)) {
        const Vec3<T>& out = plane.outwards;
        if (std::abs(out.x) < kEvenPlane<T>) continue;
        const T x = (plane.offset + slack + std::max(out.z * distance.low, out.z * distance.high) +
                     std::max(-out.y * y.low, -out.y * y.high)) /
                    out.x;
        if (out.x > T(0))
            bounds.high = std::min(bounds.high, x);
        else
            bounds.low = std::max(bounds.low, x);
    }
    return bounds;
}

}  // namespace fbrdf

// AxesAbout.h - a frame about one direction, where any will do.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <array>

namespace fbrdf {

/// The x and y axes of a right-handed frame whose z is `axis`, unit (Duff, Burgess, Christensen,
/// Hery, Kensler, Liani, Villemin 2017, "Building an Orthonormal Basis, Revisited", Listing 3). The
/// frame jumps at axis.z = 0.
template <class T>
std::array<Vec3<T>, 2> axesAbout(const Vec3<T>& axis)
{
    const T sign = axis.z < T(0) ? T(-1) : T(1);
    const T a = T(-1) / (sign + axis.z), b = axis.x * axis.y * a;
    return {Vec3<T>(T(1) + sign * axis.x * axis.x * a, sign * b, -sign * axis.x),
            Vec3<T>(b, sign + axis.y * axis.y * a, -axis.y)};
}

}  // namespace fbrdf

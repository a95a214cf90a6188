// Directions.h - low-discrepancy points and directions: the same in every run, with no clumps.
// Reference: Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences" (the R_d
// sequence).
#pragma once
#include <fbrdf/brdf/HalfDifference.h>

#include <array>
#include <cmath>

namespace fbrdf::test {

constexpr int kPoints = 4096;

/// Point n of the sequence in [0, 1)^4.
inline std::array<double, 4> point(int n)
{
    constexpr double kRoot = 1.1673039782614187;  // the root of x^5 = x + 1
    std::array<double, 4> p{};
    double step = 1.0;
    for (double& coordinate : p) {
        step /= kRoot;
        coordinate = std::fmod(0.5 + step * (n + 1), 1.0);
    }
    return p;
}

/// A direction that is uniform over the part of the hemisphere with z from `leastZ` to 1.
inline Vec3d direction(double u, double v, double leastZ = 1e-3)
{
    return directionFromAngles(std::acos(leastZ + (1.0 - leastZ) * u), 2.0 * kPi * v);
}

/// Pair n; both directions are above the horizon.
inline DirectionPair<double> pair(int n, double leastZ = 1e-3)
{
    const auto p = point(n);
    return {direction(p[0], p[1], leastZ), direction(p[2], p[3], leastZ)};
}

inline double distance(const Vec3d& a, const Vec3d& b)
{
    return glm::length(a - b);
}

}  // namespace fbrdf::test

// Pairs.h - direction pairs for the tests of the models: the awkward ones, and many others.
#pragma once
#include <fbrdf/brdf/HalfDifference.h>

#include <cmath>
#include <vector>

namespace fbrdf::test {

inline Vec3d directionDegrees(double theta, double phi)
{
    return directionFromAngles(theta * kPi / 180.0, phi * kPi / 180.0);
}

/// Element k of the radical inverse sequence (Halton 1960), in [0, 1).
inline double radicalInverse(unsigned k, unsigned base)
{
    double value = 0.0, digit = 1.0 / base;
    for (; k > 0; k /= base, digit /= base) value += digit * (k % base);
    return value;
}

/// `count` pairs that fill the hemisphere twice, cosine-distributed, none within 0.6 degrees of the
/// horizon.
inline std::vector<DirectionPair<double>> spreadPairs(unsigned count)
{
    const auto direction = [](double u, double v) {
        return directionFromAngles(std::asin(std::sqrt(0.9999 * u)), 2.0 * kPi * v);
    };
    std::vector<DirectionPair<double>> pairs;
    for (unsigned k = 1; k <= count; ++k)
        pairs.push_back({direction(radicalInverse(k, 2), radicalInverse(k, 3)),
                         direction(radicalInverse(k, 5), radicalInverse(k, 7))});
    return pairs;
}

/// Normal, mirror, retro-reflection, opposite and crossed azimuths, at elevations from 1e-15 up,
/// and a vertical direction that rounding has made longer than 1.
inline std::vector<DirectionPair<double>> awkwardPairs()
{
    const Vec3d normal(0.0, 0.0, 1.0);
    std::vector<DirectionPair<double>> pairs = {{normal, normal},
                                                {Vec3d(0.0, 0.0, 1.0 + 2.2e-16), normal}};
    for (const double z : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.2, 0.7, 1.0 - 1e-9, 1.0 - 1e-15}) {
        const double radius = std::sqrt((1.0 - z) * (1.0 + z));
        for (const double phi : {0.0, 0.5 * kPi, 2.0}) {
            const Vec3d w(radius * std::cos(phi), radius * std::sin(phi), z);
            pairs.push_back({w, w});
            pairs.push_back({w, Vec3d(-w.x, -w.y, w.z)});
            pairs.push_back({w, Vec3d(-w.y, w.x, w.z)});
            pairs.push_back({w, normal});
            pairs.push_back({w, directionFromAngles(0.5 * kPi - 1e-7, 1.0)});
        }
    }
    return pairs;
}

}  // namespace fbrdf::test

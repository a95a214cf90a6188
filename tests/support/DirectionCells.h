// DirectionCells.h - draws of directions against the density that is claimed for them: counts in
// cells of the sphere, by chi-square.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fbrdf::test {

inline Vec3d directionAt(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// Cells over the whole sphere, even in theta and phi.
constexpr int kCellRows = 24, kCellColumns = 48;
inline size_t directionCell(const Vec3d& w)
{
    const int row =
        std::clamp(static_cast<int>(std::acos(std::clamp(w.z, -1.0, 1.0)) / kPi * kCellRows), 0,
                   kCellRows - 1);
    const double turn = std::atan2(w.y, w.x) / (2.0 * kPi) + 0.5;
    const int column = std::clamp(static_cast<int>(turn * kCellColumns), 0, kCellColumns - 1);
    return static_cast<size_t>(row * kCellColumns + column);
}

/// The probability of each cell by a fine sum.
template <class Density>
std::vector<double> cellProbabilities(const Density& density)
{
    constexpr int kFine = 20;
    std::vector<double> result(static_cast<size_t>(kCellRows * kCellColumns), 0.0);
    for (int i = 0; i < kCellRows * kFine; ++i)
        for (int j = 0; j < kCellColumns * kFine; ++j) {
            const double theta = kPi * (i + 0.5) / (kCellRows * kFine);
            const double phi = 2.0 * kPi * ((j + 0.5) / (kCellColumns * kFine) - 0.5);
            const Vec3d w = directionAt(theta, phi);
            result[directionCell(w)] += density(w) * std::sin(theta) * 2.0 * kPi * kPi /
                                        (kCellRows * kFine * kCellColumns * kFine);
        }
    return result;
}

/// Standard deviations by which chi-square exceeds its mean, over cells with enough samples.
inline double chiSquareExcess(const std::vector<double>& expected, const std::vector<int>& counts,
                              int samples)
{
    double sum = 0.0, cells = 0.0;
    for (size_t i = 0; i < counts.size(); ++i) {
        const double mean = expected[i] * samples;
        if (mean < 5.0) continue;
        sum += (counts[i] - mean) * (counts[i] - mean) / mean;
        cells += 1.0;
    }
    return (sum - cells) / std::sqrt(2.0 * cells);
}

}  // namespace fbrdf::test

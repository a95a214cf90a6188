// PriorSample.h - how samples count where tables are fitted for a prior, or with one.
#pragma once
#include <algorithm>
#include <cmath>

namespace fbrdf {

/// Octaves in a difference of 1 of natural logarithms.
constexpr double kOctave = 1.442695;

/// The logarithm of f in 1/sr to the base 2; what is darker than 0.0003 counts as that.
inline double log2OfPriorSample(double f)
{
    constexpr double kLeastValue = 3e-4;
    return std::log2(std::max(f, kLeastValue));
}

/// What a sample counts whose channels have this mean, in 1/sr: (mean / (mean + 0.001))^2, so that
/// what is black need not be black to a percent, and a little more, so that it counts at all.
inline double weightOfPriorSample(double mean)
{
    constexpr double kBlack = 1e-3, kLeastWeight = 1e-4;
    const double seen = mean / (mean + kBlack);
    return seen * seen + kLeastWeight;
}

}  // namespace fbrdf

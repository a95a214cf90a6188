// Random.h - numbers for one path that depend on nothing but its name.
#pragma once
#include <fbrdf/base/SplitMix.h>
#include <fbrdf/brdf/Conventions.h>

#include <array>
#include <cmath>

namespace fbrdf::truth {

/// The first numbers of a path, which choose its first directions, are spread evenly over the paths
/// of a pixel: they go on by fixed steps (Roberts 2018, "The Unreasonable Effectiveness of
/// Quasirandom Sequences": R6) from a place that is random for each pixel (Cranley, Patterson
/// 1976). Those after them are random.
class Random {
public:
    Random(uint64_t seed, uint64_t pixel, uint64_t sample)
        : pixel_(splitMix64(splitMix64(seed) + pixel)),
          state_(splitMix64(pixel_ + sample)),
          sample_(static_cast<double>(sample))
    {
    }
    /// In [0, 1).
    double one()
    {
        if (used_ == kSteps.size()) return hashed(state_++);
        // The odd factor keeps the names of these numbers away from those of paths.
        const double start = hashed(pixel_ ^ (~used_ * 0x9e3779b97f4a7c15u));
        const double place = start + sample_ * kSteps[used_++];
        return place - std::floor(place);
    }
    Vec2<double> two()
    {
        const double first = one();
        return {first, one()};
    }

private:
    /// 53 bits.
    static double hashed(uint64_t x) { return static_cast<double>(splitMix64(x) >> 11) * 0x1p-53; }

    // Powers of the root of x^7 = x + 1, inverted.
    static constexpr std::array<double, 6> kSteps{0.8986537126286992,  0.80757849522134473,
                                                  0.72573341296975968, 0.65218302594397148,
                                                  0.58608669757796927, 0.52668898670073572};

    uint64_t pixel_, state_;
    double sample_;
    size_t used_ = 0;
};

}  // namespace fbrdf::truth

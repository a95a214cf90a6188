// Random.h - numbers for one path that depend on nothing but its name.
#pragma once
#include <fbrdf/base/SplitMix.h>
#include <fbrdf/brdf/Conventions.h>

namespace fbrdf::truth {

class Random {
public:
    Random(uint64_t seed, uint64_t pixel, uint64_t sample)
        : state_(splitMix64(splitMix64(splitMix64(seed) + pixel) + sample))
    {
    }
    /// In [0, 1), 53 bits.
    double one() { return static_cast<double>(splitMix64(state_++) >> 11) * 0x1p-53; }
    Vec2<double> two()
    {
        const double first = one();
        return {first, one()};
    }

private:
    uint64_t state_;
};

}  // namespace fbrdf::truth

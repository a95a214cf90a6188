// SplitMix.h - a hash of 64 bits, which chooses without a pattern: folds, samples, paths of light.
// Reference: Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators": splitmix64.
#pragma once
#include <cstdint>

namespace fbrdf {

/// A bijection of 64-bit words in which every bit of x moves about half of the bits of the result.
inline uint64_t splitMix64(uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

}  // namespace fbrdf

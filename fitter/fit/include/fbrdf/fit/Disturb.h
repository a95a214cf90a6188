// Disturb.h - noise, lost samples and spikes added to good data, to test what fits make of them.
#pragma once
#include <fbrdf/sources/Source.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fbrdf {

/// The changes to every value, in this order. Each channel is changed by itself, but zeros and
/// spikes hit a sample as a whole. Noise is normal.
struct Noise {
    double relative = 0.10;   ///< sigma of a factor about 1
    double absolute = 0.004;  ///< sigma of what is added, over cos theta_i: a radiance's noise
    double zeroed = 0.01;     ///< share of samples that become 0
    double spiked = 0.003;    ///< share of samples times `spike`
    double spike = 8.0;
};
/// The same samples for a seed, on every machine.
std::vector<Sample> withNoise(std::vector<Sample> samples, const Noise& noise, uint64_t seed);

/// `count` of the samples, chosen at random, in their order; all where there are no more.
std::vector<Sample> randomPart(const std::vector<Sample>& samples, size_t count, uint64_t seed);

}  // namespace fbrdf

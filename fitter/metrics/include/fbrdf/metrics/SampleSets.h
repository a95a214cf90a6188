// SampleSets.h - pairs of directions at which functions are fitted and compared.
#pragma once
#include <fbrdf/sources/Source.h>

#include <cstddef>
#include <vector>

namespace fbrdf {

/// Elevation below which the uniform sets have no direction, radians.
constexpr double kMinElevation = 2.0 * kPi / 180.0;

/// Pairs of the uniform test set in every figure that fbrdf prints.
constexpr size_t kUniformTestPairs = 65536;

/// The uniform test set of the metrics: `count` Sobol pairs, half
/// cosine-distributed in wo and wi, half uniform in (sqrt theta_h, theta_d, phi_h, phi_d); all
/// above kMinElevation. Pairs that fall below are replaced by the next points of the sequence. f is
/// not filled in.
std::vector<DirectionPair<double>> uniformPairs(size_t count, uint64_t seed = 0);

/// Samples of source.evaluate at pairs.
std::vector<Sample> samplesAt(const Source& source, const std::vector<DirectionPair<double>>& pairs,
                              int threads);

}  // namespace fbrdf

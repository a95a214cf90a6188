// Sobol.h - the Sobol sequence in up to four dimensions, digitally shifted.
// Reference: Joe and Kuo 2008, "Constructing Sobol sequences with better two-dimensional
// projections" (table of 2010, dimensions 1 to 4).
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace fbrdf {

/// Point `index` in [0, 1)^4. The seed shifts all points alike (xor of the digits): another seed is
/// another set with the same uniformity; seed 0 is the plain sequence moved by half a cell, so that
/// 0 never occurs.
std::array<double, 4> sobolPoint(uint32_t index, uint64_t seed);

}  // namespace fbrdf

// TexelWeights.h - the texels that are supported by samples.
#pragma once
#include "solve/LeastSquares.h"

#include <fbrdf/brdf/Material.h>

#include <vector>

namespace fbrdf {

/// Sum of interpolation weights of every unknown over the samples with a channel above the noise
/// floor. For a stream it is counted on a part of it: 262,144 samples.
std::vector<double> supportOf(const LeastSquares& problem);

/// Sum of interpolation weights that supports a texel: a tenth of what a sample that lies on it
/// gives.
constexpr double kSupport = 0.1;

/// Sets Table::unsupported of every table: reachable texels whose sum of interpolation weights
/// (supportOf, one number an unknown) is at or below kSupport. A symmetric table's
/// mirrored texels share their sum.
void markUnsupported(Material& material, const Layout& layout, const std::vector<double>& support);

}  // namespace fbrdf

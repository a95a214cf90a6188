// TexelWeights.h - the texels that are supported by samples.
#pragma once
#include "solve/LeastSquares.h"

#include <fbrdf/brdf/Material.h>

#include <vector>

namespace fbrdf {

/// Sum of interpolation weights of every unknown over the samples with a channel above the noise
/// floor. For a stream it is counted on a part of it: 262,144 samples.
std::vector<double> texelWeights(const LeastSquares& problem);

/// Sum of interpolation weights that supports a texel: a tenth of what a sample that lies on it
/// gives.
constexpr double kLeastTexelWeight = 0.1;

/// Sets Table::unsupported of every table: reachable texels whose sum of interpolation weights
/// (`weights`: see texelWeights, one number an unknown) is at or below kLeastTexelWeight. A
/// symmetric table's mirrored texels share their sum.
void markUnsupported(Material& material, const Layout& layout, const std::vector<double>& weights);

}  // namespace fbrdf

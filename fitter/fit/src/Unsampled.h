// Unsampled.h - what the texels hold that no sample supports.
#pragma once
#include "solve/LeastSquares.h"

#include <vector>

namespace fbrdf {

/// Gives texels without support the hue of the nearest texels that have it, and leaves them as
/// bright as the smoothness made them. Each channel alone goes on along a slope of its own, which
/// noise decides: where a table ends beyond its samples, channels that run apart are a hue that is
/// in no sample. `weights`: see texelWeights; a texel has it above kLeastTexelWeight. The nearest
/// are those at the fewest steps along the axes of the table; several count alike.
void extendHue(const Form& form, const Layout& layout, const std::vector<double>& weights,
               State& x);

}  // namespace fbrdf

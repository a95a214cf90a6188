// Quantize.h - from solved log texels to the rounded material that is stored.
#pragma once
#include "solve/LeastSquares.h"

namespace fbrdf {

/// Fixes the gauge (each table's mean log is 0, or its maximum for linear8; the constants go to
/// the scale of each term), clamps
/// texels that no position can reach into the range of the others, and rounds to `storage`.
Material quantize(const Form& form, const Layout& layout, const State& x, Storage storage);

}  // namespace fbrdf

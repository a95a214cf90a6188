// Coarse.h - a form with half as many texels along every axis, and the way back: sums of terms are
// solved coarse first, where steps cost little and a poor start does no harm.
#pragma once
#include "solve/LeastSquares.h"

namespace fbrdf {

/// The same form over tables of half the size, at least 4 knots an axis. Equal to `form` when
/// nothing can shrink.
Form halved(const Form& form);

/// A state of the halved form on the texels of the full one, by linear interpolation.
State prolonged(const LeastSquares& coarse, const State& x, const LeastSquares& fine);

}  // namespace fbrdf

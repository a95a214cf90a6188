// Flatten.h - how bright a material is where no sample was taken.
//
// Smoothness goes on along the slope of the last samples. Where that slope is steep the material
// would give back more light than it gets, hundreds of times as much at grazing angles.
#pragma once
#include "FitContext.h"

namespace fbrdf {

/// Where a directional albedo exceeds 1, extends the texels without support (Table::unsupported)
/// less steeply, in steps from the slopes of smoothness to no slope at all, as far as it takes.
/// Where the samples themselves demand more than 1 it stops near the least that is reached; texels
/// with support never move. Hues stay those of the nearest texels with support (extendHue).
/// Precondition: `fitted` was solved for (Fitted::solution).
void flattenGaps(const FitContext& context, Fitted& fitted);

}  // namespace fbrdf

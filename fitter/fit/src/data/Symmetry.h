// Symmetry.h - what a source does not depend on: forms that leave it out spend nothing on it.
#pragma once
#include <fbrdf/sources/Source.h>

namespace fbrdf {

/// Unchanged by a rotation about the normal: can be fitted in angles alone. Said by the source, or
/// seen on pairs of directions of its function.
bool isIsotropicSource(const Source& source);

/// Known to be unchanged when wo and wi change places, within a hundredth in the median. Scattered
/// samples seldom have both, and measurements seldom are: false where there is no function.
bool isReciprocalSource(const Source& source);

}  // namespace fbrdf

// Symmetry.h - the symmetries of a source: forms that have them as well spend no texels on what
// does not change.
#pragma once
#include <fbrdf/sources/Source.h>

namespace fbrdf {

/// Unchanged by a rotation about the normal: can be fitted in angles alone. Stated by the source,
/// or found on 65,536 pairs of directions of its function.
bool isIsotropicSource(const Source& source);

/// True when the function is known to be unchanged when wo and wi change places: the median of
/// |ln f(a, b) / f(b, a)| is below `within`. Scattered samples seldom contain both pairs, and
/// measurements are seldom reciprocal: false where there is no function.
bool isReciprocalSource(const Source& source, double within);

/// True when the function of an isotropic source is known to be its own mirror image at the plane
/// of incidence, within a twentieth in the median: networks differ by less for want of training.
/// True where there is no function.
bool isMirrorSymmetricSource(const Source& source);

/// The samples turned about the normal, each by an angle of its own: to an isotropic source they
/// are the same, to a form with maps over directions they are not.
std::vector<Sample> turned(std::vector<Sample> samples);

}  // namespace fbrdf

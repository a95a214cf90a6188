// Isotropy.h - whether a source can be fitted in angles alone.
#pragma once
#include <fbrdf/sources/Source.h>

namespace fbrdf {

/// Known to be isotropic, or a function that turning pairs about the normal does not change.
/// Scattered samples of which nothing is known are not.
bool isIsotropicSource(const Source& source);

}  // namespace fbrdf

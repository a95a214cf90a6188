// SampleSymmetry.h - isotropic or not, from scattered samples alone.
#pragma once
#include <fbrdf/sources/Source.h>

#include <vector>

namespace fbrdf {

/// True when samples of the same theta_i, theta_o and |phi_o - phi_i| agree wherever they lie about
/// the normal and on whichever side of the plane of incidence, as near samples on one side do. All
/// wi in one plane, as a goniometer that does not turn its sample leaves them, have their two sides
/// compared. False where too few samples can be: nothing speaks for it then.
bool areIsotropic(const std::vector<Sample>& samples);

/// The same of a source that knows its samples only. Of a stream 65,536 rows are read, in pieces
/// spread over all of it: reading 50 million rows twice would double the time of their fit.
bool hasIsotropicSamples(const Source& source);

}  // namespace fbrdf

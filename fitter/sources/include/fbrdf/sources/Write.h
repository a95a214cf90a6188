// Write.h - sources to files that other programs read. A file appears whole or not at all.
#pragma once
#include <fbrdf/sources/Source.h>

namespace fbrdf {

/// Scattered samples as text, the project's own CSV (wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,r,g,b, and
/// weight where one differs from 1): float values in the shortest form that reads back the same. A
/// source without samples is evaluated at 65536 pairs spread over both hemispheres, half of them
/// about the highlight. Throws Error(output).
void writeCsv(const Source& source, const std::string& path);

/// A MERL .binary table of 90 x 90 x 180 cells, each with f at its centre and phi_h = 0; cells
/// below the horizon, and those where f is not a finite number >= 0, are -1 in all channels. A
/// source that streams the cells of that grid is copied cell by cell. Throws Error(output), or
/// Error(usage) for a source that has neither such samples nor `evaluate`.
void writeMerl(const Source& source, const std::string& path);

}  // namespace fbrdf

// CompareSheet.h - one material as several sides of a comparison have it, and maps of how far each
// is from the first.
#pragma once
#include "World.h"

namespace fbrdf::viewer {

/// Writes the sides of options.compare of the one material of the world; where that is empty the
/// reference, the material as drawn, the maps of 2001, four singular values and the best GGX lobes,
/// as far as the material has them. A column for each has its picture and, below, the map of its
/// error against the first. Writes to options.out, and the numbers to options.stats where that is
/// not empty. Throws what drawnSide, checkLayout and writing throw.
void writeCompareSheet(const Options& options, World& world);

}  // namespace fbrdf::viewer

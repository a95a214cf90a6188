// CompareDrawing.h - two sides of a comparison without a window: fitted, drawn, laid over each
// other and written.
#pragma once
#include "World.h"

namespace fbrdf::viewer {

/// Draws both sides of options.compare of the one material of the world, and writes what
/// options.out and options.stats ask for: a picture, or a film of a flip or a wipe. Throws
/// Error(usage) for a side that the material does not have, and what fitting, drawing and writing
/// throw.
void writeComparison(const Options& options, World& world);

}  // namespace fbrdf::viewer

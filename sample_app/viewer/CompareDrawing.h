// CompareDrawing.h - two sides of a comparison without a window: fitted, drawn, laid over each
// other and written.
#pragma once
#include "CompareSide.h"
#include "World.h"

namespace fbrdf::viewer {

/// A side that was drawn, without background.
struct DrawnSide {
    Picture picture;
    scene::CompareSideStats stats;
};

/// Fits what a side of the one material of the world needs, and draws it. Throws Error(usage) for a
/// side that the material does not have, and what fitting and drawing throw.
DrawnSide drawnSide(const CompareSide& side, Options options, World& world);

/// Draws both sides of options.compare of the one material of the world, and writes what
/// options.out and options.stats ask for: a picture, or a film of a flip or a wipe. Throws what
/// drawnSide and writing throw.
void writeComparison(const Options& options, World& world);

}  // namespace fbrdf::viewer

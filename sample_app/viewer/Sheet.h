// Sheet.h - a contact sheet: each material under each light, with labels.
#pragma once
#include "World.h"

namespace fbrdf::viewer {

/// Rows are the materials of the world and columns what options.under names; under a single light
/// the materials fill a square. Each picture has options.width x options.height pixels. Throws
/// Error(usage) for a sheet of more than 16384 pixels a side, and what drawing throws.
scene::Image drawSheet(const Options& options, World& world);

}  // namespace fbrdf::viewer

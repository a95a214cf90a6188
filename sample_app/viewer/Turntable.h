// Turntable.h - an object that turns once, as an animation or as a folder of pictures.
#pragma once
#include "World.h"

namespace fbrdf::viewer {

/// Writes options.frames pictures of the world's object, turned about +y by equal steps, to
/// options.out: a GIF or WebP that plays for ever, or a folder, which is made where it is missing,
/// of frame-000.png, ... All appear together or none does. Throws Error(output), and what drawing
/// throws.
void writeTurntable(const Options& options, World& world);

}  // namespace fbrdf::viewer

// WindowLoop.h - the viewer with a window.
#pragma once
#include "World.h"

namespace fbrdf::viewer {

/// Shows the world until the window is closed, or for options.frames frames, one material at a
/// time. Returns the last picture. Throws Error(gl) where there is no display.
Picture runWindow(const Options& options, World& world);

}  // namespace fbrdf::viewer

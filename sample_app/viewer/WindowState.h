// WindowState.h - what a window begins with.
#pragma once
#include "World.h"

#include <fbrdf/scene/Controls.h>

#include <string>

namespace fbrdf::viewer {

/// The document of a world that was loaded, and the names that keys go through.
scene::ViewState initialState(const Options& options, const World& world);

/// The folder whose materials are shown to choose from: the one asked for, or that of the first
/// file among the materials; empty where there is none.
std::string browsedFolder(const Options& options);

}  // namespace fbrdf::viewer

// RoundingProbe.h - how a context rounds what it stores: values are drawn, blended and read back.
#pragma once
#include "Objects.h"

namespace fbrdf::gl {

/// What Capabilities::rounding says, or what was measured, of each format that the context can draw
/// to; measured once. It touches and leaves what measuring a filter does (FilterProbe.h). Where it
/// cannot be measured, and of formats that are none of ours, it is what OpenGL grants. Throws
/// nothing.
const StoreRoundings& storeRoundings(const DevicePtr& device);

}  // namespace fbrdf::gl

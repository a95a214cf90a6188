// FilterProbe.h - how finely a context filters textures: a ramp is drawn and read back.
#pragma once
#include "Objects.h"

namespace fbrdf::gl {

/// What Capabilities::filter says, or what was measured, once for each type of texel and target.
/// Measuring touches what a draw and an upload touch, and what reading pixels does; all of it is
/// left as StateMode demands. Where it cannot be measured, it is taken to be as coarse as 8 bits
/// between texels are, and Device::whyFilterAssumed says why. Throws nothing.
FilterPrecision filterPrecision(const DevicePtr& device, TexelType type, GLenum target);

}  // namespace fbrdf::gl

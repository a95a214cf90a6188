// TargetInfo.h - the format of the host's framebuffer.
#pragma once
#include "Device.h"

namespace fbrdf::gl {

struct TargetInfo {
    ColourFormat format = ColourFormat::other;
    StoreUnit otherUnit = {};  ///< where the format is `other`
    int samples = 1;           ///< of a pixel
    bool floatDepth = false;
    Transfer transfer = Transfer::linear;
};

/// Describes the draw framebuffer that is bound. Throws Error(gl) where it cannot be drawn to:
/// incomplete, without a colour buffer or without depth.
TargetInfo targetInfo(const Device& device, const Target& target);

}  // namespace fbrdf::gl

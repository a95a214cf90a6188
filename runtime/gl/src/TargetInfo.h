// TargetInfo.h - what the host's framebuffer is.
#pragma once
#include "Device.h"

namespace fbrdf::gl {

struct TargetInfo {
    ColourFormat format = ColourFormat::other;
    bool multisampled = false;
    bool floatDepth = false;
    Transfer transfer = Transfer::linear;
};

/// Of the bound draw framebuffer. Throws Error(gl) where it cannot be drawn to: incomplete, without
/// a colour buffer or without depth.
TargetInfo targetInfo(const Device& device, const Target& target);

}  // namespace fbrdf::gl

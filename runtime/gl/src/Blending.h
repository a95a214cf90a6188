// Blending.h - how a pass adds to what a surface has (Blend).
#pragma once
#include "Functions.h"

namespace fbrdf::gl {

/// Of draw buffer 0 alone, as the host may blend in others. Alpha becomes that of a pass that
/// replaces, and later passes leave it alone.
void setBlend(const Functions& gl, Blend blend);

}  // namespace fbrdf::gl

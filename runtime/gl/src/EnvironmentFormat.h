// EnvironmentFormat.h - what is decided of the cube map of an environment before it is made.
#pragma once
#include "Device.h"

#include <fbrdf/environment/Prefilter.h>
#include <fbrdf/gl/Environment.h>

#include <limits>

namespace fbrdf::gl {

struct EnvironmentFormat {
    int size = 0;
    bool floats = false, unfiltered = false, gradual = false;
    /// What a texel can store at most.
    float largest() const { return floats ? std::numeric_limits<float>::max() : 65504.0f; }
    int levels() const { return prefilteredLevels(size); }
};

/// Throws Error(usage) for a size that is none, Error(gl) for one that the context has not.
EnvironmentFormat environmentFormat(const Device& device, const EnvironmentOptions& options);

}  // namespace fbrdf::gl

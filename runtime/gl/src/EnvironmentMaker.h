// EnvironmentMaker.h - makes the prefiltered cube map of an environment by drawing, or on the CPU.
#pragma once
#include "EnvironmentResources.h"

#include <fbrdf/environment/Panorama.h>

namespace fbrdf::gl {

using EnvironmentPtr = std::shared_ptr<EnvironmentResources>;

/// Where the GPU cannot, the CPU makes it, and a note is logged. Throws Error(gl) where GL cannot
/// store it.
EnvironmentPtr makeEnvironment(const DevicePtr& device, const Panorama& panorama,
                               const EnvironmentFormat& format);
/// Throws Error(gl) where GL cannot make it, or for a name that is no such texture.
EnvironmentPtr makeEnvironment(const DevicePtr& device, const HostEnvironment& source,
                               const EnvironmentFormat& format);

}  // namespace fbrdf::gl

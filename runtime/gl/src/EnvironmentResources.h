// EnvironmentResources.h - the prefiltered cube map of an environment.
#pragma once
#include "Objects.h"

#include <fbrdf/environment/Prefilter.h>
#include <fbrdf/gl/Environment.h>

namespace fbrdf::gl {

/// What the maker of a cube has decided.
struct EnvironmentFormat {
    int size = 0;
    bool floats = false, unfiltered = false;
    int levels() const { return prefilteredLevels(size); }
};
/// Throws Error(usage) for a size that is none, Error(gl) for one that the context has not.
EnvironmentFormat environmentFormat(const Device& device, const EnvironmentOptions& options);

class EnvironmentResources {
public:
    /// Uploads a prefiltered cube. Throws Error(gl) where GL cannot store it.
    EnvironmentResources(DevicePtr device, const CubeImage& prefiltered,
                         const EnvironmentFormat& format, std::string whyNotOnGpu);
    /// Takes a cube map that has all levels.
    EnvironmentResources(DevicePtr device, Object cube, const EnvironmentFormat& format);

    /// Keeps the cube that was not prefiltered: a cube map that has all levels, or one to upload.
    void keepUnfiltered(Object cube) { unfiltered_ = std::move(cube); }
    void keepUnfiltered(const CubeImage& cube);

    EnvironmentResources(const EnvironmentResources&) = delete;
    EnvironmentResources& operator=(const EnvironmentResources&) = delete;

    const Device* device() const { return device_.get(); }
    GLuint texture() const { return cube_.name(); }
    GLuint unfiltered() const { return unfiltered_.name(); }  ///< 0: there is none
    int size() const { return format_.size; }
    int levels() const { return format_.levels(); }
    const std::string& whyNotOnGpu() const { return whyNotOnGpu_; }

private:
    DevicePtr device_;
    EnvironmentFormat format_;
    Object cube_, unfiltered_;
    std::string whyNotOnGpu_;
};

/// Gives the cube map that is bound levels without content, and its filter.
void allocateCube(const Functions& gl, int size, int levels, bool floats);

}  // namespace fbrdf::gl

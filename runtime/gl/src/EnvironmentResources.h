// EnvironmentResources.h - the prefiltered cube map of an environment.
#pragma once
#include "LobeLevels.h"

#include <optional>

namespace fbrdf::gl {

class EnvironmentResources {
public:
    /// Uploads a prefiltered cube. Throws Error(gl) where GL cannot store it.
    EnvironmentResources(DevicePtr device, const CubeImage& prefiltered,
                         const EnvironmentFormat& format, std::string whyNotOnGpu);
    /// Takes a cube map that has all levels, or whose levels are still being drawn.
    EnvironmentResources(DevicePtr device, Object cube, const EnvironmentFormat& format,
                         LobeLevels levels);

    /// Keeps the cube that was not prefiltered.
    void keepUnfiltered(const CubeImage& cube);

    /// Draws so many texels more, or what is left. Throws Error(gl).
    void refine(long long texels);
    bool isFinished() const { return !unfinished_; }

    EnvironmentResources(const EnvironmentResources&) = delete;
    EnvironmentResources& operator=(const EnvironmentResources&) = delete;

    const Device* device() const { return device_.get(); }
    GLuint texture() const { return cube_.name(); }
    GLuint unfiltered() const;  ///< the cube that was not prefiltered; 0: it is not kept
    int size() const { return format_.size; }
    int levels() const { return format_.levels(); }
    const std::string& whyNotOnGpu() const { return whyNotOnGpu_; }

private:
    void finish();

    DevicePtr device_;
    EnvironmentFormat format_;
    Object cube_, unfiltered_;
    std::optional<LobeLevels> unfinished_;
    std::string whyNotOnGpu_;
};

/// Gives the cube map that is bound levels without content, and its filter.
void allocateCube(const Functions& gl, int size, int levels, bool floats);

}  // namespace fbrdf::gl

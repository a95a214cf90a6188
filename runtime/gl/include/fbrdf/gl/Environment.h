// Environment.h - light from everywhere: a prefiltered cube map on the GPU, made once for all
// materials, and how a draw uses it (docs/method.md, Environment light).
//
// Materials reflect it by their lobes (Material::lobes). Those of a material that has none are
// fitted on a thread of their own, which the first draw or prepare with an environment starts;
// until then it is drawn without, and its destructor waits for the fit. Rotation and intensity are
// uniforms: they may change in every frame and cost nothing.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <glm/mat3x3.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace fbrdf::gl {

class EnvironmentResources;

struct EnvironmentOptions {
    /// Texels on a side of a face: a power of two from 8 on. 0: 512, or 256 where a CPU samples
    /// textures. Below 512 the narrowest lobes are as wide as a face's texels ask for.
    int size = 0;
    /// Stores RGBA32F instead of RGBA16F, which ends at 65504 and is half as large: radiance beyond
    /// that is clamped.
    bool floats = false;
    /// Keeps the cube that was not prefiltered as well, with all levels, which
    /// EnvironmentLight::samples needs: RGBA32F, 32 MiB where faces have 512 texels.
    bool unfiltered = false;
    /// Leaves levels of more than 32 texels on a side to Renderer::refine: the environment can be
    /// drawn with at once, what reflects sharply looks blurred at first, and no frame waits for
    /// all. Without effect where a CPU makes the environment, or gives it prefiltered.
    bool gradual = false;
};

/// Radiance in a texture of the host, linear Rec. 709. It is read while the environment is made.
struct HostEnvironment {
    uint32_t texture = 0;
    /// A cube map instead of a 2D texture of latitude and longitude (Panorama.h), whose row 0 is
    /// the first that was uploaded. Its own mipmaps are not read.
    bool cube = false;
};

/// An environment on the GPU. Lifetime and threads are those of Handles.h.
class GpuEnvironment {
public:
    explicit GpuEnvironment(std::shared_ptr<EnvironmentResources> resources)
        : resources_(std::move(resources))
    {
    }
    GpuEnvironment(const GpuEnvironment&) = delete;
    GpuEnvironment& operator=(const GpuEnvironment&) = delete;

    int size() const;    ///< texels on a side of a face of level 0
    int levels() const;  ///< see prefilteredLevels (Prefilter.h)
    /// The name of the cube map, which is the renderer's; for backgrounds and tests.
    uint32_t texture() const;
    /// That of the cube that was not prefiltered; 0 without EnvironmentOptions::unfiltered.
    uint32_t unfilteredTexture() const;
    /// False while levels are left to Renderer::refine.
    bool isFinished() const;
    /// Why the CPU made it; empty where the GPU did.
    const std::string& whyNotOnGpu() const;

    const EnvironmentResources& resources() const { return *resources_; }  ///< for the renderer
    EnvironmentResources& resources() { return *resources_; }              ///< the same

private:
    std::shared_ptr<EnvironmentResources> resources_;
};

/// What a draw takes from an environment.
struct EnvironmentLight {
    const GpuEnvironment* map = nullptr;  ///< null: there is none
    /// Turns directions of the environment to those of the world; orthonormal.
    glm::mat3 rotation{1.0f};
    Vec3f intensity{1.0f};  ///< multiplies the radiance; finite, >= 0
    /// 0: as a material's table has; else at most so many tilted ones, or 1, 3 or all bent ones for
    /// 1, 2 and 3. Packed ones (GpuLibrary) have all.
    int lobes = 0;
    /// 0: lobes are looked up. Else so many directions are drawn by the lobes, at most kMostSamples
    /// (SampledLight.h), and for each the material's own maps and the unfiltered cube are looked
    /// up, at the level that its density asks for: the quality mode, in a pass of its own. It needs
    /// EnvironmentOptions::unfiltered and Technique::single without a limit of look-ups; packed
    /// materials, and those whose lobes uniforms have no room for, are drawn by their lobes
    /// (DrawStats::whyNotSampled). There is no noise: every pixel has the same directions about its
    /// normal. 64 suffice in soft light; small lamps that are hundreds of times as
    /// bright as the rest need more than 256 (docs/benchmarks.md).
    int samples = 0;
};

/// The rotation about +y by an angle in radians.
glm::mat3 environmentRotation(float angle);

}  // namespace fbrdf::gl

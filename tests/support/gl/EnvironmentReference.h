// EnvironmentReference.h - what the renderer should draw under an environment, from the lobes of a
// table and the texels that are on the GPU, and under area lights: on the CPU in double.
#pragma once
#include <fbrdf/environment/CubeImage.h>
#include <fbrdf/gl/Renderer.h>

#include "EnvironmentScenes.h"
#include "Reference.h"

namespace fbrdf::test {

/// The texels of an environment's cube map as the GPU has them. The desktop's GL only.
CubeImage readCube(const GladGLContext& gl, const gl::GpuEnvironment& environment);

/// The same of the cube that was not prefiltered.
CubeImage readUnfilteredCube(const GladGLContext& gl, const gl::GpuEnvironment& environment);

/// RGBA per pixel, 0 outside the mesh: directions that are drawn by the lobes of the material, as
/// many as the light asks for. cube: from readUnfilteredCube.
std::vector<double> sampledImage(const Material& material, const CubeImage& cube,
                                 const GeometryBuffer& geometry, const gl::View& view,
                                 const gl::EnvironmentLight& light);

/// RGBA per pixel, 0 outside the mesh. cube: from readCube.
std::vector<double> environmentImage(const LobeTable& table, const CubeImage& cube,
                                     const GeometryBuffer& geometry, const gl::View& view,
                                     const gl::EnvironmentLight& light);

/// The same under area lights, in the space of the world.
std::vector<double> areaLightImage(const LobeTable& table, const std::vector<AreaLight>& lights,
                                   const GeometryBuffer& geometry, const gl::View& view);

}  // namespace fbrdf::test

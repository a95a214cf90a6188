// EnvironmentReference.h - what the renderer should draw under an environment: the lobes of a table
// and the texels that are on the GPU, on the CPU in double.
#pragma once
#include <fbrdf/environment/CubeImage.h>
#include <fbrdf/gl/Renderer.h>

#include "EnvironmentScenes.h"
#include "Reference.h"

namespace fbrdf::test {

/// The texels of an environment's cube map as the GPU has them. The desktop's GL only.
CubeImage readCube(const GladGLContext& gl, const gl::GpuEnvironment& environment);

/// RGBA per pixel, 0 outside the mesh. cube: from readCube.
std::vector<double> environmentImage(const LobeTable& table, const CubeImage& cube,
                                     const GeometryBuffer& geometry, const gl::View& view,
                                     const gl::EnvironmentLight& light);

}  // namespace fbrdf::test

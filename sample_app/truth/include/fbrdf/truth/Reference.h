// Reference.h - the picture by definition, in double: the geometry is read back from GL, and the
// sum over lights of f cos E (docs/method.md, Eq. 2) is evaluated on the CPU for each pixel.
#pragma once
#include <fbrdf/gl/Renderer.h>
#include <fbrdf/headless/Offscreen.h>

#include <glad/gl.h>

#include <functional>
#include <vector>

namespace fbrdf::truth {

/// Per pixel, bottom row first, in eye space as the lighting programs receive it.
struct GeometryBuffer {
    std::vector<float> position, normal, tangent;  ///< RGBA; alpha 1 where the mesh is
    bool covers(size_t pixel) const { return position[4 * pixel + 3] == 1.0f; }
};

/// Draws the mesh with the runtime's own vertex shader.
GeometryBuffer geometryBuffer(const GladGLContext& gl, Offscreen& offscreen,
                              const gl::MeshData& mesh, const glm::mat4& model,
                              const gl::View& view);

/// What changes the shading besides material and lights. Functions that are empty change nothing.
struct SurfaceReference {
    double handedness = 1.0;                    ///< of every tangent
    std::function<Vec3d(size_t pixel)> normal;  ///< of a normal map, in the tangent frame
    std::function<double(size_t light, const Vec3d& position)> shadow;
};

/// RGBA per pixel, 0 outside the mesh.
std::vector<double> referenceImage(const Material& material, const GeometryBuffer& geometry,
                                   const std::vector<Light>& lights, const gl::View& view,
                                   const SurfaceReference& surface = {});

}  // namespace fbrdf::truth

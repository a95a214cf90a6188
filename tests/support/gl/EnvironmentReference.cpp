#include "EnvironmentReference.h"

#include <fbrdf/plan/AreaContour.h>

#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/environment/Prefilter.h>
#include <fbrdf/environment/SampledLight.h>

#include <glm/matrix.hpp>

#include <cmath>

namespace fbrdf::test {
namespace {

Vec3d rgbOf(const std::vector<float>& image, size_t pixel)
{
    return {image[4 * pixel], image[4 * pixel + 1], image[4 * pixel + 2]};
}

CubeImage readLevels(const GladGLContext& gl, uint32_t texture, int size, int levels)
{
    CubeImage cube{size, {}};
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, texture);
    for (int level = 0; level < levels; ++level) {
        const auto side = static_cast<size_t>(cube.sizeOf(static_cast<size_t>(level)));
        auto& texels = cube.levels.emplace_back(6 * side * side);
        for (size_t face = 0; face < 6; ++face)
            gl.GetTexImage(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), level,
                           GL_RGB, GL_FLOAT, texels.data() + face * side * side);
    }
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
    return cube;
}

/// A pixel of a mesh.
struct ReferencePixel {
    ShadingFrame<double> frame;  ///< eye space
    Vec3d position;              ///< the same
    Vec3d wo;                    ///< local
};

/// RGBA per pixel from what a covered pixel whose front is seen reflects.
template <class Radiance>
std::vector<double> imageOf(const GeometryBuffer& geometry, const gl::View& view,
                            const Radiance& radiance)
{
    const bool perspective = view.projection[3][3] == 0.0f;
    std::vector<double> image(geometry.position.size(), 0.0);
    for (size_t pixel = 0; pixel < image.size() / 4; ++pixel) {
        if (!geometry.covers(pixel)) continue;
        const Vec3d position = rgbOf(geometry.position, pixel);
        const auto frame =
            shadingFrame(rgbOf(geometry.normal, pixel), rgbOf(geometry.tangent, pixel));
        const Vec3d viewer = perspective ? glm::normalize(-position) : Vec3d(0.0, 0.0, 1.0);
        const Vec3d wo = frame.local(viewer);
        image[4 * pixel + 3] = 1.0;
        if (!(wo.z > 0.0)) continue;
        const Vec3d total = radiance(ReferencePixel{frame, position, wo});
        for (int c = 0; c < 3; ++c) image[4 * pixel + static_cast<size_t>(c)] = total[c];
    }
    return image;
}

glm::dmat3 fromEyeTo(const gl::EnvironmentLight& light, const gl::View& view)
{
    return glm::transpose(glm::dmat3(light.rotation)) *
           glm::transpose(glm::dmat3(glm::dmat4(view.view)));
}

}  // namespace

CubeImage readCube(const GladGLContext& gl, const gl::GpuEnvironment& environment)
{
    return readLevels(gl, environment.texture(), environment.size(), environment.levels());
}

CubeImage readUnfilteredCube(const GladGLContext& gl, const gl::GpuEnvironment& environment)
{
    int levels = 1;
    while (environment.size() >> levels) ++levels;
    return readLevels(gl, environment.unfilteredTexture(), environment.size(), levels);
}

std::vector<double> sampledImage(const Material& material, const CubeImage& cube,
                                 const GeometryBuffer& geometry, const gl::View& view,
                                 const gl::EnvironmentLight& light)
{
    const glm::dmat3 fromEye = fromEyeTo(light, view);
    const auto f = [&](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(evaluate<double>(material, wo, wi));
    };
    return imageOf(geometry, view, [&](const ReferencePixel& pixel) {
        const ShadingFrame<double> turned{fromEye * pixel.frame.t, fromEye * pixel.frame.s,
                                          fromEye * pixel.frame.n};
        return sampledLight(cube, material.lobes, f, turned, pixel.wo, light.samples) *
               Vec3d(light.intensity);
    });
}

std::vector<double> environmentImage(const LobeTable& table, const CubeImage& cube,
                                     const GeometryBuffer& geometry, const gl::View& view,
                                     const gl::EnvironmentLight& light)
{
    const glm::dmat3 fromEye = fromEyeTo(light, view);
    return imageOf(geometry, view, [&](const ReferencePixel& pixel) {
        const auto lookUp = [&](const Vec3d& axis, double level) {
            const auto& [t, s, n] = pixel.frame;
            return samplePrefiltered(cube, fromEye * (t * axis.x + s * axis.y + n * axis.z), level);
        };
        const LobeSum<double> sum = lobesAt<double>(table, pixel.wo);
        Vec3d total = sum.cosine * lookUp({0.0, 0.0, 1.0}, kCosineLevel);
        for (size_t k = 0; k < static_cast<size_t>(sum.lobes); ++k)
            total += sum.weight[k] * lookUp(sum.axis[k], sum.level[k]);
        return total * Vec3d(light.intensity);
    });
}

std::vector<double> areaLightImage(const LobeTable& table, const std::vector<AreaLight>& lights,
                                   const GeometryBuffer& geometry, const gl::View& view)
{
    std::vector<AreaVectors> areas;
    for (const AreaLight& light : lights) appendAreaVectors(light, 0, glm::dmat4(view.view), areas);
    return imageOf(geometry, view, [&](const ReferencePixel& pixel) {
        const LobeSum<double> sum = lobesAt<double>(table, pixel.wo);
        Vec3d total(0.0);
        for (const AreaVectors& area : areas)
            total += areaReflected(sum, pixel.frame, area, pixel.position);
        return total;
    });
}

}  // namespace fbrdf::test

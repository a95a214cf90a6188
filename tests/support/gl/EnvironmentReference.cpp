#include "EnvironmentReference.h"

#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/environment/Prefilter.h>

#include <glm/matrix.hpp>

#include <cmath>

namespace fbrdf::test {
namespace {

Vec3d rgbOf(const std::vector<float>& image, size_t pixel)
{
    return {image[4 * pixel], image[4 * pixel + 1], image[4 * pixel + 2]};
}

}  // namespace

CubeImage readCube(const GladGLContext& gl, const gl::GpuEnvironment& environment)
{
    CubeImage cube{environment.size(), {}};
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, environment.texture());
    for (int level = 0; level < environment.levels(); ++level) {
        const auto side = static_cast<size_t>(cube.sizeOf(static_cast<size_t>(level)));
        auto& texels = cube.levels.emplace_back(6 * side * side);
        for (size_t face = 0; face < 6; ++face)
            gl.GetTexImage(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), level,
                           GL_RGB, GL_FLOAT, texels.data() + face * side * side);
    }
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
    return cube;
}

std::vector<double> environmentImage(const LobeTable& table, const CubeImage& cube,
                                     const GeometryBuffer& geometry, const gl::View& view,
                                     const gl::EnvironmentLight& light)
{
    const bool perspective = view.projection[3][3] == 0.0f;
    const glm::dmat3 fromEye = glm::transpose(glm::dmat3(light.rotation)) *
                               glm::transpose(glm::dmat3(glm::dmat4(view.view)));
    std::vector<double> image(geometry.position.size(), 0.0);
    for (size_t pixel = 0; pixel < image.size() / 4; ++pixel) {
        if (!geometry.covers(pixel)) continue;
        const auto frame =
            shadingFrame(rgbOf(geometry.normal, pixel), rgbOf(geometry.tangent, pixel));
        const Vec3d viewer =
            perspective ? glm::normalize(-rgbOf(geometry.position, pixel)) : Vec3d(0.0, 0.0, 1.0);
        const Vec3d wo = frame.local(viewer);
        image[4 * pixel + 3] = 1.0;
        if (!(wo.z > 0.0)) continue;
        const auto lookUp = [&](const Vec3d& axis, double level) {
            const Vec3d inEye = frame.t * axis.x + frame.s * axis.y + frame.n * axis.z;
            return samplePrefiltered(cube, fromEye * inEye, level);
        };
        const LobeSum<double> sum = lobesAt<double>(table, wo);
        Vec3d total = sum.cosine * lookUp({0.0, 0.0, 1.0}, kCosineLevel);
        for (size_t k = 0; k < static_cast<size_t>(sum.lobes); ++k)
            total += sum.weight[k] * lookUp(sum.axis[k], sum.level[k]);
        for (int c = 0; c < 3; ++c)
            image[4 * pixel + static_cast<size_t>(c)] = total[c] * double(light.intensity[c]);
    }
    return image;
}

}  // namespace fbrdf::test

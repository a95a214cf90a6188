#include "CubeSample.h"

#include <fbrdf/base/Assert.h>

#include <cmath>

namespace fbrdf {
namespace {

/// Filtered over the edges of faces; beyond a corner of the cube there is no texel, and the mean of
/// the three others stands for it (OpenGL 4.6, 8.14.1, leaves the choice).
Vec3f filteredAtBorder(const std::vector<Vec3f>& texels, const CubePlace& place, int size)
{
    const CubeStencil stencil = cubeStencilAt(place, size, true);
    Vec3f sum(0.0f), mean(0.0f);
    float missing = 0.0f;
    for (size_t k = 0; k < 4; ++k) {
        const auto weight = static_cast<float>(stencil.weight[k]);
        if (stencil.texel[k] < 0) {
            missing = weight;
            continue;
        }
        const Vec3f& texel = texels[static_cast<size_t>(stencil.texel[k])];
        sum += weight * texel;
        mean += texel / 3.0f;
    }
    return stencil.isWhole ? sum : sum + missing * mean;
}

Vec3f filteredInLevel(const std::vector<Vec3f>& texels, const CubePlace& place, int size)
{
    const double x = 0.5 * size * (place.s + 1.0) - 0.5, y = 0.5 * size * (place.t + 1.0) - 0.5;
    const double last = size - 1;
    if (!(x >= 0.0 && x < last && y >= 0.0 && y < last))
        return filteredAtBorder(texels, place, size);
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const auto right = static_cast<float>(x - column), down = static_cast<float>(y - row);
    const Vec3f* upper = &texels[static_cast<size_t>((place.face * size + row) * size + column)];
    const Vec3f* lower = upper + size;
    return (1.0f - down) * ((1.0f - right) * upper[0] + right * upper[1]) +
           down * ((1.0f - right) * lower[0] + right * lower[1]);
}

}  // namespace

Vec3d cubeTexelDirection(int face, int x, int y, int size)
{
    return glm::normalize(cubePoint(face, x, y, size));
}

Vec3f sampleCubeAt(const CubeImage& cube, const CubePlace& place, double level)
{
    const auto last = static_cast<double>(cube.levels.size() - 1);
    const double clamped = level > 0.0 ? std::min(level, last) : 0.0;
    const auto lower = static_cast<size_t>(clamped);
    const auto fraction = static_cast<float>(clamped - static_cast<double>(lower));
    const Vec3f near = filteredInLevel(cube.levels[lower], place, cube.sizeOf(lower));
    if (!(fraction > 0.0f)) return near;
    const Vec3f far = filteredInLevel(cube.levels[lower + 1], place, cube.sizeOf(lower + 1));
    return (1.0f - fraction) * near + fraction * far;
}

Vec3d sampleCube(const CubeImage& cube, const Vec3d& direction, double level)
{
    FBRDF_ASSERT(cube.levels.size(), >=, size_t(1));
    return Vec3d(sampleCubeAt(cube, cubePlace(direction), level));
}

}  // namespace fbrdf

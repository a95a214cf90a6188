#include <fbrdf/brdf/CubeFaces.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// OpenGL 4.6, table 8.19, solved for the direction: axis + s S + t T with s, t in [-1, 1].
constexpr double kFrames[kFaces][3][3] = {
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
    {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}};

Vec3d vectorOf(int face, int which)
{
    const double* v = kFrames[face][which];
    return {v[0], v[1], v[2]};
}

double texelOf(double place, int size)
{
    return 0.5 * size * (place + 1.0) - 0.5;
}

int texelAt(int face, int x, int y, int size)
{
    const bool beyondX = x < 0 || x >= size, beyondY = y < 0 || y >= size;
    if (beyondX && beyondY) return -1;
    if (!beyondX && !beyondY) return (face * size + y) * size + x;
    const CubePlace at = cubePlace(cubePoint(face, x, y, size));
    const auto nearest = [size](double p) {
        return std::clamp(static_cast<int>(std::lround(texelOf(p, size))), 0, size - 1);
    };
    return (at.face * size + nearest(at.t)) * size + nearest(at.s);
}

}  // namespace

Vec3d cubePoint(int face, double x, double y, int size)
{
    const double s = (2.0 * x + 1.0) / size - 1.0, t = (2.0 * y + 1.0) / size - 1.0;
    const double beyond = std::max(0.0, std::max(std::abs(s), std::abs(t)) - 1.0);
    return (1.0 - beyond) * vectorOf(face, 0) + std::clamp(s, -1.0, 1.0) * vectorOf(face, 1) +
           std::clamp(t, -1.0, 1.0) * vectorOf(face, 2);
}

CubePlace cubePlace(const Vec3d& direction)
{
    const Vec3d a = glm::abs(direction);
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    const int face = 2 * axis + (direction[axis] < 0.0 ? 1 : 0);
    const auto along = [&](int which) {
        const double place = glm::dot(direction, vectorOf(face, which)) / a[axis];
        return place >= -1.0 && place <= 1.0 ? place : 0.0;  // 0 where it is not a number
    };
    return {face, along(1), along(2)};
}

CubeStencil cubeStencil(const Vec3d& direction, int size, bool seamless)
{
    return cubeStencilAt(cubePlace(direction), size, seamless);
}

CubeStencil cubeStencilAt(const CubePlace& place, int size, bool seamless)
{
    const double atX = texelOf(place.s, size), atY = texelOf(place.t, size);
    const double left = std::floor(atX), top = std::floor(atY);
    const double x = atX - left, y = atY - top;
    CubeStencil stencil;
    stencil.weight = {(1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y};
    for (int k = 0; k < 4; ++k) {
        int column = static_cast<int>(left) + k % 2, row = static_cast<int>(top) + k / 2;
        if (!seamless) {
            column = std::clamp(column, 0, size - 1);
            row = std::clamp(row, 0, size - 1);
        }
        const int texel = texelAt(place.face, column, row, size);
        stencil.texel[static_cast<size_t>(k)] = texel;
        stencil.isWhole = stencil.isWhole && texel >= 0;
    }
    return stencil;
}

}  // namespace fbrdf

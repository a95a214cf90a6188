// Raster.h - which triangle each pixel sees, by OpenGL's rules, in double.
//
// A pixel is covered when its centre is inside a triangle whose corners were snapped to 1/256
// pixel, ties going to the left and the bottom edge (the top-left rule of a framebuffer
// object, whose row 0 is the bottom one; OpenGL leaves it open); the nearest depth wins; attributes
// are interpolated with perspective. So the picture covers the same pixels as GL's but for corners
// that float arithmetic snaps to another 1/256. Reference: OpenGL 3.3 core specification,
// section 3.6.1 (interpolation: Eq. 3.6, 3.7); Direct3D 11 functional specification, section 3.4
// (snapping and the top-left rule, which Mesa follows).
#pragma once
#include <fbrdf/scene/Meshes.h>

#include <glm/mat4x4.hpp>

#include <vector>

namespace fbrdf::scene {

/// One mesh in the world. `material` is an index into whatever the caller keeps.
struct Instance {
    const Mesh* mesh = nullptr;
    glm::mat4 model{1.0f};
    int material = 0;
};

/// What a pixel sees: a point of a triangle of an instance.
struct Fragment {
    int instance = -1;   ///< -1: nothing
    uint32_t first = 0;  ///< position in mesh->indices of the triangle's first corner
    double depth = 1.0;  ///< in [-1, 1], OpenGL's
    /// Weights of the three corners, perspective-correct, of sum 1. They are a little outside [0,
    /// 1] where snapping moved an edge over the pixel's centre.
    Vec3d weights{0.0};
    bool covered() const { return instance >= 0; }
};

struct Fragments {
    int width = 0, height = 0;
    std::vector<Fragment> pixels;  ///< height x width, row 0 is the top

    const Fragment& at(int x, int y) const
    {
        return pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
    }
};

/// Both sides of a triangle are seen, as in the runtime. Corners may lie anywhere, also behind the
/// camera.
Fragments rasterise(const std::vector<Instance>& instances, const gl::View& view, int width,
                    int height);

/// Value of a vertex attribute at a fragment. T: Vec3d; the values may be of another precision.
template <class T, class Values>
T interpolate(const Values& values, const Mesh& mesh, const Fragment& fragment)
{
    T sum(0.0);
    for (int k = 0; k < 3; ++k)
        sum += fragment.weights[k] *
               T(values[mesh.indices[fragment.first + static_cast<uint32_t>(k)]]);
    return sum;
}

}  // namespace fbrdf::scene

// CubeImage.h - radiance as a cube map with levels, sampled as OpenGL samples a seamless one: what
// the renderer has on the GPU, on the CPU.
#pragma once
#include <fbrdf/environment/Panorama.h>

#include <algorithm>

namespace fbrdf {

struct CubeImage {
    int size = 0;  ///< texels on a side of a face of level 0
    /// The faces of each level, in the order and orientation of OpenGL (+x -x +y -y +z -z), rows by
    /// increasing t.
    std::vector<std::vector<Vec3f>> levels;

    int sizeOf(size_t level) const { return std::max(1, size >> level); }
};

/// The unit direction of the centre of a texel of a face with `size` texels on a side.
Vec3d cubeTexelDirection(int face, int x, int y, int size);

/// Filtered linearly between texels, across the edges of faces, and between levels; level is
/// clamped to those that there are. At a corner of the cube, where three texels meet, the missing
/// fourth is their mean. The direction need not be unit.
Vec3d sampleCube(const CubeImage& cube, const Vec3d& direction, double level);

/// The picture on a cube, with all levels down to one texel a face. A texel is the mean of the
/// panorama over the solid angle of the texel, each level the mean of four texels of the one
/// before. size: a power of two.
CubeImage cubeOfPanorama(const Panorama& panorama, int size, int threads = 0);

}  // namespace fbrdf

// CubeFaces.h - the faces of a cube map as OpenGL orders and turns them, and how it filters them.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <array>

namespace fbrdf {

constexpr int kFaces = 6;  ///< +x -x +y -y +z -z

/// Point on the cube [-1, 1]^3 at a position of a face, in texels as in a Table; a position outside
/// of the face is folded over its edge.
Vec3d cubePoint(int face, double x, double y, int size);

/// Where a direction meets the cube: s and t of OpenGL in [-1, 1].
struct CubePlace {
    int face;
    double s, t;
};
/// The direction need not be unit; one that is 0 or not a number gives some place of some face.
CubePlace cubePlace(const Vec3d& direction);

/// The texels that linear filtering mixes, face after face, and their weights.
struct CubeStencil {
    std::array<int, 4> texel{};  ///< -1 beyond a corner of the cube, where there is no texel
    std::array<double, 4> weight{};
    bool isWhole = true;  ///< all four texels exist
};

/// seamless: filters across the edges of faces; otherwise a face is read as if its border went on.
CubeStencil cubeStencil(const Vec3d& direction, int size, bool seamless);
CubeStencil cubeStencilAt(const CubePlace& place, int size, bool seamless);

}  // namespace fbrdf

// Meshes.h - the generated meshes of the viewer, and what every mesh needs: bounds, default frames.
//
// Object space, counter-clockwise seen from outside, unit normals, unit tangents at right angles to
// them. A mesh is gl::MeshData: what is drawn on the CPU is what the runtime uploads.
#pragma once
#include <fbrdf/gl/Renderer.h>

#include <string>

namespace fbrdf::scene {

using Mesh = gl::MeshData;

/// Unit sphere at the origin of `segments` x `rings` quads (triangles at the poles). Tangent: along
/// increasing azimuth about +y. Each pole is `segments` vertices, because its tangent depends on
/// where it is approached from. Expects segments >= 3, rings >= 2.
Mesh makeSphere(int segments = 256, int rings = 128);

/// A tube around a trefoil knot, inside the ball of radius 1.2. Normals are exact;
/// the tangent is that of the knot, so an anisotropic material is brushed along the tube. Expects
/// both counts >= 3.
Mesh makeKnot(int along = 512, int around = 64);

/// The square [-1, 1]^2 at z = 0 of cells x cells quads: normal +z, tangent +x. Expects cells >= 1.
Mesh makePlane(int cells = 32);

/// "sphere", "knot", "plane" or the path of an OBJ file (ObjFile.h, which says what is thrown).
Mesh meshFromName(const std::string& name);

/// Ball around all positions: centre of their box, radius to the farthest. Radius 0 when empty.
struct Bounds {
    Vec3f centre{0.0f};
    float radius = 0.0f;
};
Bounds boundsOf(const Mesh& mesh);

}  // namespace fbrdf::scene

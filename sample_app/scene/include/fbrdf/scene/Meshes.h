// Meshes.h - the generated meshes of the viewer, and what every mesh needs: bounds, default frames.
//
// Meshes are in object space and counter-clockwise seen from outside, with unit normals and unit
// tangents at right angles to them. A mesh is gl::MeshData, so that the CPU draws what the runtime
// uploads.
#pragma once
#include <fbrdf/gl/Renderer.h>

#include <optional>
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

/// Makes "sphere", "knot" or "plane", or reads an OBJ file (and throws what readObj throws).
Mesh meshFromName(const std::string& name);

/// A generated one with a sixth of the triangles or less, for pictures of few pixels; nothing where
/// the mesh is as coarse already, or a file.
std::optional<Mesh> coarseMeshFromName(const std::string& name);

/// The ball around all positions: its centre is that of their box, its radius reaches the farthest.
/// The radius of an empty mesh is 0.
struct Bounds {
    Vec3f centre{0.0f};
    float radius = 0.0f;
};
Bounds boundsOf(const Mesh& mesh);

}  // namespace fbrdf::scene

// VertexFrames.h - normals and tangents for meshes that have none.
#pragma once
#include <fbrdf/scene/Meshes.h>

#include <glm/vec2.hpp>

#include <vector>

namespace fbrdf::scene {

/// Smooth normals, one a position: those of the adjacent faces weighted by their angle there
/// (Thuermer and Wuethrich 1998, "Computing Vertex Normals from Polygonal Facets"). +z where no
/// face of non-zero area touches. `indices`: three a triangle, into positions.
std::vector<Vec3f> smoothNormals(const std::vector<Vec3f>& positions,
                                 const std::vector<uint32_t>& indices);

/// The tangent of a surface without texture coordinates: increasing azimuth about +y, as on the
/// sphere; +x where the normal is +-y. Unit, orthogonal to the unit normal.
Vec3f azimuthTangent(const Vec3f& normal);

/// `direction` without its part along the unit `normal`, unit; azimuthTangent where nothing is
/// left.
Vec3f orthogonalTangent(const Vec3f& direction, const Vec3f& normal);

/// Fills mesh.tangents from texture coordinates, one a position: the direction of growing u,
/// averaged over the faces. azimuthTangent where a vertex has no usable coordinates.
void computeTangents(Mesh& mesh, const std::vector<glm::vec2>& textureCoordinates);

}  // namespace fbrdf::scene

// ObjFile.h - Wavefront OBJ, the geometry of it: v, vt, vn, f with polygons of any size, negative
// (relative) indices and continued lines; and the tangents of the Waterloo meshes (`r x y z` lines,
// not in the standard), one for each vn, or one for each v where there are no vn.
//
// Groups, materials, lines, points and free-form surfaces are skipped. Missing normals are made
// smooth. Missing tangents are made along growing u, or along increasing azimuth about +y where the
// file has no texture coordinates (VertexFrames.h). Polygons are cut into triangles
// (Triangulate.h). Reference: Wavefront, "Object Files (.obj)", Advanced Visualizer manual,
// appendix B1.
#pragma once
#include <fbrdf/scene/Meshes.h>

#include <string>
#include <string_view>

namespace fbrdf::scene {

/// Throws Error(input, "FILE:LINE", ...) for a file that is missing or not such geometry: a number
/// that is missing or not finite, an index out of range, a face of fewer than 3 or more than 2048
/// corners, no face.
Mesh readObj(const std::string& path);

/// The same from memory; `where` stands for the file's name in errors.
Mesh parseObj(std::string_view text, const std::string& where);

}  // namespace fbrdf::scene

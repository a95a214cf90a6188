// Triangulate.h - a simple polygon in space cut into triangles by ear clipping.
// Reference: Meisters 1975, "Polygons have ears". O(n^2): meant for the faces of meshes.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <array>
#include <vector>

namespace fbrdf::scene {

/// Corner numbers of size - 2 triangles that keep the orientation of the polygon. Expects at least
/// three corners, roughly in one plane. Where no ear exists (a polygon that crosses itself or has
/// no area) the rest is cut as a fan.
std::vector<std::array<int, 3>> triangulate(const std::vector<Vec3d>& corners);

}  // namespace fbrdf::scene

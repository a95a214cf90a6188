// Triangulate.h - a simple polygon in space cut into triangles by ear clipping, or into convex
// facets. Reference: Meisters 1975, "Polygons have ears". O(n^2): meant for the faces of meshes and
// for lights.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <array>
#include <vector>

namespace fbrdf {

/// Corner numbers of size - 2 triangles that keep the orientation of the polygon. Expects at least
/// three corners, roughly in one plane. Where no ear exists (a polygon that crosses itself or has
/// no area) the rest is cut as a fan.
std::vector<std::array<int, 3>> triangulate(const std::vector<Vec3d>& corners);

/// The same as convex facets of four corners, of which the last two may be one.
std::vector<std::array<int, 4>> convexFacets(const std::vector<Vec3d>& corners);

/// The area as a vector along the normal (Sutherland, Sproull, Schumacker 1974: Newell's method),
/// which points to where the corners run counterclockwise.
Vec3d vectorArea(const std::vector<Vec3d>& corners);

}  // namespace fbrdf

// ColourMap.h - numbers as colours of evenly growing lightness.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <string>

namespace fbrdf {

/// viridis (Smith and van der Walt 2015) at t, clamped to [0, 1], by Zucker's polynomial of degree
/// 6 (2019): sRGB values in [0, 1], within 0.02 of the table.
Vec3d viridis(double t);

/// "#rrggbb" of display values in [0, 1].
std::string hexColour(const Vec3d& colour);

}  // namespace fbrdf

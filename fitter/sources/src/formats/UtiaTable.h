// UtiaTable.h - the angular grid of UTIA's anisotropic BRDF database (Filip and Vavra 2014,
// "Template-Based Sampling of Anisotropic BRDFs"), shared by its two file formats.
// 288 x 288 cells: rows are the light, theta_i = 0, 15, .. 75 degrees times phi_i = 0, 7.5, ..
// 352.5, phi contiguous; columns the view in the same way.
#pragma once
#include <fbrdf/sources/Source.h>

namespace fbrdf {

constexpr size_t kUtiaSide = size_t(6) * 48;
constexpr size_t kUtiaCells = kUtiaSide * kUtiaSide;

/// What `evaluate` does beyond 75 degrees, where the table has no cells.
enum class UtiaBeyond {
    kept,         ///< takes the value at 75 degrees
    extrapolated  ///< goes on linearly, as the readers of the database do, often to below 0
};

/// `cells` - kUtiaCells values of f, row (light) by row, 1/sr. The source evaluates linearly in all
/// four angles; values below 0 and not finite count as 0. The samples are the cells. A direction
/// along the normal is one pair for 48 azimuths, and weighs as one.
Source makeUtiaSource(std::vector<Vec3f> cells, UtiaBeyond beyond = UtiaBeyond::kept);

}  // namespace fbrdf

// TableFigures.h - the maps of a material as pictures and curves.
#pragma once
#include "Picture.h"

#include <fbrdf/brdf/Material.h>

#include <string>

namespace fbrdf {

/// The values that a picture of a table shows from black to white: log2 F for log tables, F for
/// linear ones, and for signed ones F with 0 in the middle.
struct ShownRange {
    double low = 0, high = 1;
};
/// Share of the texels at either end that a picture of a log table may clip, so that one wild texel
/// does not grey out the rest.
constexpr double kClipped = 0.01;
/// The range of the texels that some direction can reach, over all channels. Curves show every
/// texel.
ShownRange shownRange(const Table& table);

/// One pixel a texel, slices of 3D tables below each other. Log tables: display value (log2 F -
/// low) / (high - low); signed tables the same of F; linear tables: sRGB of F. Texels outside the
/// disc are transparent.
Picture pictureOf(const Table& table, const ShownRange& range);

/// A figure for each table: disc maps with rings of zenith angle, angle grids with axes in degrees,
/// 1D tables as curves.
std::string tableFigures(const Material& material);

}  // namespace fbrdf

// ClusterSpans.h - the neighbouring tiles of a row that a light meets, found at once from the two
// lines through the edges of the tiles.
#pragma once
#include "ClusterTiles.h"

#include <vector>

namespace fbrdf {

/// A light in the tiles [first, last) of a row of a slice.
struct LightSpan {
    int32_t light;
    int16_t slice, row, first, last;
};

/// Appends the spans of a light in rows [firstRow, lastRow) of a slice, by row. light: the number
/// that they get.
void addSpans(const ClusterTiles& tiles, int slice, int firstRow, int lastRow, int32_t light,
              const Reach& reach, std::vector<LightSpan>& spans);

}  // namespace fbrdf

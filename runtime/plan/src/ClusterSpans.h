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

/// The tiles [first, last) of one row after another, none where last <= first.
struct RowEnds {
    static constexpr int kMost = 32;  ///< rows that are found side by side
    int row = 0, count = 0;           ///< the rows [row, row + count)
    int first[kMost], last[kMost];
};

/// The tiles of a slice that a light with a radius meets, by blocks of rows.
class SpanFinder {
public:
    /// tiles, reach: must outlive it.
    SpanFinder(const Tiles& tiles, int firstRow, int lastRow, const Reach& reach);
    /// The next block of rows in [firstRow, lastRow) that the light may meet; false where there is
    /// none.
    bool next(RowEnds& ends);

private:
    const Tiles& tiles_;
    const Reach& reach_;
    double radius_ = 0.0,
           radiusSquared_;  ///< of the sphere's largest section parallel to the picture
    int row_ = 0, end_ = 0;
};

/// Appends the spans of a light in rows [firstRow, lastRow) of a slice, by row. light: the number
/// that they get.
void addSpans(const ClusterTiles& tiles, int slice, int firstRow, int lastRow, int32_t light,
              const Reach& reach, std::vector<LightSpan>& spans);

}  // namespace fbrdf

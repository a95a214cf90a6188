// ClusterLists.h - the lists of all clusters, made at once: the lights of each are counted, then
// filled in from spans.
#pragma once
#include "ClusterSpans.h"

#include <fbrdf/base/Workers.h>

#include <vector>

namespace fbrdf {

/// A light in the tiles [first, last) of a row.
struct ColumnSpan {
    int32_t light;
    int16_t first, last;
};

/// The lights of a row of tiles, by slot. A row at a time fits into the fastest memory when its
/// lists are filled.
struct ListRow {
    std::vector<ColumnSpan> spans;
    size_t used = 0;  ///< the first so many of `spans`

    /// Drops an empty span, without a branch that processors would guess wrong.
    void add(int32_t light, int firstColumn, int lastColumn)
    {
        if (used == spans.size()) spans.resize(2 * used + 64);
        spans[used] = {light, static_cast<int16_t>(firstColumn), static_cast<int16_t>(lastColumn)};
        used += firstColumn < lastColumn ? 1 : 0;
    }
};

/// Rows [first, last) of the tiles of a slice, which one task fills.
struct ListBand {
    int slice = 0, first = 0, last = 0;
    std::vector<ListRow> rows;
    std::vector<int32_t> counts;         ///< lights of each tile
    std::vector<int32_t> changes, next;  ///< of the tiles of one row
    std::vector<int32_t> entries;        ///< the lists of one row
    size_t total = 0, begin = 0;         ///< entries of the band, and before it
};

/// Memory that is kept because so much of it costs more than filling it.
struct ListMemory {
    std::vector<std::pair<int, int>> ranges;  ///< the slices [first, second) of each light
    /// The lights that may be in each slice, ascending: those of slice s are ofSlices[firsts[s]] to
    /// ofSlices[firsts[s + 1]].
    std::vector<size_t> firsts, next;
    std::vector<int32_t> ofSlices;
    std::vector<ListBand> bands;
};

/// Makes the lists of the lights from clusters.everywhere on. reachesByPlace: of lights with a
/// radius; others, where they stand in lists, are in all. Throws Error(usage) for more than 2^31 -
/// 1 entries.
void setLists(LightClusters& clusters, const ClusterTiles& tiles,
              const std::vector<Reach>& reachesByPlace, Workers& workers, ListMemory& memory);

}  // namespace fbrdf

// ClusterLists.h - the lists of all clusters, made at once: the lights of each are counted, then
// filled in from spans.
#pragma once
#include "ClusterSpans.h"

#include <fbrdf/base/Workers.h>

#include <vector>

namespace fbrdf {

/// Rows [first, last) of the tiles of a slice, which one task fills.
struct ListBand {
    int slice = 0, first = 0, last = 0;
    std::vector<LightSpan> spans;
    std::vector<int32_t> differences, counts, next;  ///< lights of each tile
    size_t total = 0, begin = 0;                     ///< entries of the band, and before it
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

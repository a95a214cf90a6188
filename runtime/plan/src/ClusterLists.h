// ClusterLists.h - the lists of all clusters, made at once: the lights of each are counted, then
// filled in from spans.
#pragma once
#include "ClusterSpans.h"
#include "RowBits.h"

#include <fbrdf/base/Workers.h>

#include <vector>

namespace fbrdf {

/// Rows [first, last) of the tiles of a slice, which one task fills.
struct ListBand {
    int slice = 0, first = 0, last = 0;
    std::vector<int32_t> candidates;  ///< lights that may be in the slice
    std::vector<ListRow> rows;
    RowBits bits;
    size_t entries() const;  ///< of all its lists together
    size_t begin = 0;        ///< entries of the bands before it
};

/// Memory that is kept because so much of it costs more than filling it.
struct ListMemory {
    std::vector<DistanceRange<double>> distances;  ///< see findSpans; of each light
    std::vector<ListBand> bands;
};

/// Makes the lists of the lights from clusters.everywhere on. reachesByPlace: of lights with a
/// radius; others, where they stand in lists, are in all. Throws Error(usage) for more than 2^31 -
/// 1 entries.
void setLists(LightClusters& clusters, const ClusterTiles& tiles,
              const std::vector<Reach>& reachesByPlace, Workers& workers, ListMemory& memory);

}  // namespace fbrdf

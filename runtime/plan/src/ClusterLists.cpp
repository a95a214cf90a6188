#include "ClusterLists.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

const Reach& reachOf(const LightClusters& clusters, const std::vector<Reach>& byPlace, size_t slot)
{
    return byPlace[static_cast<size_t>(clusters.places[slot])];
}

/// The distances from the eye that each light of a list spans, and a bit more, as of
/// ClusterTiles::slicesOf.
void setDistances(const LightClusters& clusters, const std::vector<Reach>& reaches,
                  std::vector<DistanceRange<double>>& distances)
{
    constexpr double kFarthest = std::numeric_limits<double>::infinity();
    distances.resize(clusters.lights.size());
    for (auto i = static_cast<size_t>(clusters.everywhere); i < distances.size(); ++i)
        distances[i] = isUnlimited(clusters.lights[i])
                           ? DistanceRange<double>{0.0, kFarthest}
                           : withSlack(distanceOf(reachOf(clusters, reaches, i)));
}

/// Cuts slices into bands of rows until there are enough of them for threads to end together.
void setBands(const ClusterGrid& grid, std::vector<ListBand>& bands)
{
    constexpr int kFewestBands = 8;
    const int pieces = std::clamp(kFewestBands / grid.slices, 1, grid.rows);
    bands.resize(static_cast<size_t>(grid.slices * pieces));
    for (int k = 0; k < grid.slices * pieces; ++k) {
        const int piece = k % pieces;
        ListBand& band = bands[static_cast<size_t>(k)];
        band.slice = k / pieces;
        band.first = grid.rows * piece / pieces;
        band.last = grid.rows * (piece + 1) / pieces;
    }
}

/// Sets the lights that may be in the slice of a band, ascending, without a branch that processors
/// would guess wrong.
void findCandidates(const LightClusters& clusters, const DistanceRange<double>& slice,
                    const std::vector<DistanceRange<double>>& distances, ListBand& band)
{
    band.candidates.resize(distances.size());
    int32_t* const candidates = band.candidates.data();
    size_t count = 0;
    for (auto i = static_cast<size_t>(clusters.everywhere); i < distances.size(); ++i) {
        candidates[count] = static_cast<int32_t>(i);
        const bool isBefore = distances[i].high<slice.low, isBehind = distances[i].low> slice.high;
        count += isBefore || isBehind ? 0 : 1;
    }
    band.candidates.resize(count);
}

void findSpans(const LightClusters& clusters, const ClusterTiles& tiles,
               const std::vector<Reach>& reaches,
               const std::vector<DistanceRange<double>>& distances, ListBand& band)
{
    band.rows.resize(static_cast<size_t>(band.last - band.first));
    for (ListRow& row : band.rows) row.clear();
    findCandidates(clusters, tiles[band.slice].distance, distances, band);
    RowEnds ends;
    for (const int32_t light : band.candidates) {
        const auto slot = static_cast<size_t>(light);
        if (std::isinf(distances[slot].high)) {
            for (ListRow& row : band.rows) row.add(light, 0, clusters.grid.columns);
            continue;
        }
        SpanFinder finder(tiles[band.slice], band.first, band.last,
                          reachOf(clusters, reaches, slot));
        while (finder.next(ends)) {
            ListRow* const rows = &band.rows[static_cast<size_t>(ends.row - band.first)];
            for (int i = 0; i < ends.count; ++i) rows[i].add(light, ends.first[i], ends.last[i]);
        }
    }
}

void fillLists(LightClusters& clusters, ListBand& band)
{
    const ClusterGrid& grid = clusters.grid;
    const size_t end = band.begin + band.entries();
    size_t begin = band.begin,
           cluster = static_cast<size_t>((band.slice * grid.rows + band.first) * grid.columns);
    for (const ListRow& row : band.rows) {
        band.bits.makeLists(row, grid.columns, static_cast<int32_t>(begin),
                            static_cast<int32_t>(end), &clusters.lists[2 * cluster],
                            clusters.indices.data());
        begin += row.entries;
        cluster += static_cast<size_t>(grid.columns);
    }
}

}  // namespace

size_t ListBand::entries() const
{
    size_t sum = 0;
    for (const ListRow& row : rows) sum += row.entries;
    return sum;
}

void setLists(LightClusters& clusters, const ClusterTiles& tiles,
              const std::vector<Reach>& reachesByPlace, Workers& workers, ListMemory& memory)
{
    setDistances(clusters, reachesByPlace, memory.distances);
    setBands(clusters.grid, memory.bands);
    // Bands share nothing, so threads make them side by side.
    workers.run(memory.bands.size(), [&](size_t k) {
        findSpans(clusters, tiles, reachesByPlace, memory.distances, memory.bands[k]);
    });
    size_t total = 0;
    for (ListBand& band : memory.bands) {
        band.begin = total;
        total += band.entries();
    }
    // Programs read places in the lists as int.
    constexpr size_t kMost = std::numeric_limits<int32_t>::max();
    if (total > kMost)
        throw Error(ErrorKind::usage, "lists of lights",
                    Found(std::to_string(total) + " entries")
                        .expected("at most " + std::to_string(kMost) +
                                  ": fewer lights, or ones with a radius"));
    clusters.lists.resize(2 * static_cast<size_t>(clusters.grid.count()));
    clusters.indices.resize(total);
    workers.run(memory.bands.size(), [&](size_t k) { fillLists(clusters, memory.bands[k]); });
}

}  // namespace fbrdf

#include "ClusterLists.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <limits>
#include <numeric>

namespace fbrdf {
namespace {

const Reach& reachOf(const LightClusters& clusters, const std::vector<Reach>& byPlace, size_t slot)
{
    return byPlace[static_cast<size_t>(clusters.places[slot])];
}

void setLightsOfSlices(const LightClusters& clusters, const ClusterTiles& tiles,
                       const std::vector<Reach>& reaches, ListMemory& memory)
{
    const auto everywhere = static_cast<size_t>(clusters.everywhere);
    const size_t count = clusters.lights.size();
    memory.ranges.resize(count);
    memory.firsts.assign(static_cast<size_t>(clusters.grid.slices) + 1, 0);
    for (size_t i = everywhere; i < count; ++i) {
        auto& range = memory.ranges[i];
        range = isUnlimited(clusters.lights[i]) ? std::pair{0, clusters.grid.slices}
                                                : tiles.slicesOf(reachOf(clusters, reaches, i));
        for (int slice = range.first; slice < range.second; ++slice)
            ++memory.firsts[static_cast<size_t>(slice) + 1];
    }
    std::partial_sum(memory.firsts.begin(), memory.firsts.end(), memory.firsts.begin());
    memory.ofSlices.resize(memory.firsts.back());
    memory.next.assign(memory.firsts.begin(), memory.firsts.end() - 1);
    for (size_t i = everywhere; i < count; ++i)
        for (int slice = memory.ranges[i].first; slice < memory.ranges[i].second; ++slice)
            memory.ofSlices[memory.next[static_cast<size_t>(slice)]++] = static_cast<int32_t>(i);
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

void findSpans(const LightClusters& clusters, const ClusterTiles& tiles,
               const std::vector<Reach>& reaches, const ListMemory& memory, ListBand& band)
{
    const auto slice = static_cast<size_t>(band.slice);
    band.rows.resize(static_cast<size_t>(band.last - band.first));
    for (ListRow& row : band.rows) row.used = 0;
    RowEnds ends;
    for (size_t k = memory.firsts[slice]; k < memory.firsts[slice + 1]; ++k) {
        const int32_t light = memory.ofSlices[k];
        const auto slot = static_cast<size_t>(light);
        if (isUnlimited(clusters.lights[slot])) {
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

void countLights(const ClusterGrid& grid, ListBand& band)
{
    band.counts.clear();
    band.total = 0;
    for (const ListRow& row : band.rows) {
        // Differences between neighbours first; their running sum are the numbers.
        band.changes.assign(static_cast<size_t>(grid.columns) + 1, 0);
        for (size_t k = 0; k < row.used; ++k) {
            ++band.changes[static_cast<size_t>(row.spans[k].first)];
            --band.changes[static_cast<size_t>(row.spans[k].last)];
        }
        int32_t count = 0;
        for (size_t column = 0; column + 1 < band.changes.size(); ++column) {
            count += band.changes[column];
            band.counts.push_back(count);
            band.total += static_cast<size_t>(count);
        }
    }
}

/// Fills the lists of a row in memory that stays in the fastest cache, and copies them out at once.
void fillLists(LightClusters& clusters, ListBand& band)
{
    const ClusterGrid& grid = clusters.grid;
    auto begin = static_cast<int32_t>(band.begin);
    size_t cluster = static_cast<size_t>((band.slice * grid.rows + band.first) * grid.columns),
           tile = 0;
    band.next.resize(static_cast<size_t>(grid.columns));
    for (const ListRow& row : band.rows) {
        int32_t size = 0;
        for (int32_t& next : band.next) {
            clusters.lists[2 * cluster] = begin + size;
            clusters.lists[2 * cluster + 1] = band.counts[tile];
            next = size;
            size += band.counts[tile];
            ++tile, ++cluster;
        }
        if (band.entries.size() < static_cast<size_t>(size))
            band.entries.resize(2 * static_cast<size_t>(size));
        int32_t* const entries = band.entries.data();
        int32_t* const next = band.next.data();
        for (size_t k = 0; k < row.used; ++k) {
            const ColumnSpan span = row.spans[k];
            const int32_t light = span.light;
            for (int column = span.first; column < span.last; ++column)
                entries[next[column]++] = light;
        }
        std::copy_n(entries, size, clusters.indices.data() + begin);
        begin += size;
    }
}

}  // namespace

void setLists(LightClusters& clusters, const ClusterTiles& tiles,
              const std::vector<Reach>& reachesByPlace, Workers& workers, ListMemory& memory)
{
    setLightsOfSlices(clusters, tiles, reachesByPlace, memory);
    setBands(clusters.grid, memory.bands);
    // Bands share nothing, so threads make them side by side.
    workers.run(memory.bands.size(), [&](size_t k) {
        findSpans(clusters, tiles, reachesByPlace, memory, memory.bands[k]);
        countLights(clusters.grid, memory.bands[k]);
    });
    size_t total = 0;
    for (ListBand& band : memory.bands) {
        band.begin = total;
        total += band.total;
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

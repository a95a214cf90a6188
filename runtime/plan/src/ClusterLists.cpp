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
    band.spans.clear();
    for (size_t k = memory.firsts[slice]; k < memory.firsts[slice + 1]; ++k) {
        const int32_t light = memory.ofSlices[k];
        const auto slot = static_cast<size_t>(light);
        if (!isUnlimited(clusters.lights[slot])) {
            addSpans(tiles, band.slice, band.first, band.last, light,
                     reachOf(clusters, reaches, slot), band.spans);
            continue;
        }
        for (int row = band.first; row < band.last; ++row)
            band.spans.push_back({light, static_cast<int16_t>(band.slice),
                                  static_cast<int16_t>(row), 0,
                                  static_cast<int16_t>(clusters.grid.columns)});
    }
}

void countLights(const ClusterGrid& grid, ListBand& band)
{
    // Differences between neighbours first; their running sum are the numbers.
    const auto width = static_cast<size_t>(grid.columns) + 1,
               rows = static_cast<size_t>(band.last - band.first);
    band.differences.assign(width * rows, 0);
    for (const LightSpan& span : band.spans) {
        int32_t* const row = &band.differences[width * static_cast<size_t>(span.row - band.first)];
        ++row[span.first];
        --row[span.last];
    }
    band.counts.clear();
    band.total = 0;
    for (size_t row = 0; row < rows; ++row) {
        int32_t count = 0;
        for (size_t column = 0; column + 1 < width; ++column) {
            count += band.differences[row * width + column];
            band.counts.push_back(count);
            band.total += static_cast<size_t>(count);
        }
    }
}

void fillLists(LightClusters& clusters, ListBand& band)
{
    const ClusterGrid& grid = clusters.grid;
    auto first = static_cast<int32_t>(band.begin);
    const auto cluster = static_cast<size_t>((band.slice * grid.rows + band.first) * grid.columns);
    band.next.clear();
    for (size_t tile = 0; tile < band.counts.size(); ++tile) {
        clusters.lists[2 * (cluster + tile)] = first;
        clusters.lists[2 * (cluster + tile) + 1] = band.counts[tile];
        band.next.push_back(first);
        first += band.counts[tile];
    }
    int32_t* const indices = clusters.indices.data();
    for (const LightSpan& span : band.spans) {
        int32_t* const row =
            &band.next[static_cast<size_t>((span.row - band.first) * grid.columns)];
        for (int column = span.first; column < span.last; ++column)
            indices[row[column]++] = span.light;
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

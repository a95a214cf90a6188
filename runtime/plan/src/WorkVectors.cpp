#include "WorkVectors.h"

#include <cmath>

namespace fbrdf {
namespace {

// Of the distance from the eye: above the rounding of differences in float.
constexpr double kFloatSlack = 2e-6;
// Of a tile, for each tile of an axis: above the rounding of its edges in float.
constexpr double kTileSlack = 1e-6;
constexpr size_t kLightsPerTask = 256;

/// What the program takes for the reach of a light, in float.
Reach widened(const Reach& reach)
{
    Reach result = reach;
    result.radius = reach.radius * kDistanceMargin + kFloatSlack * glm::length(reach.centre);
    return result;
}

void setVectors(const Reach& reach, glm::vec4* vectors)
{
    vectors[0] = glm::vec4(glm::dvec4(reach.centre, reach.radius));
    vectors[1] = glm::vec4(glm::dvec4(reach.apex, reach.cosine));
    vectors[2] = glm::vec4(glm::dvec4(reach.axis, reach.sine));
}

/// The clusters in which the box around a sphere is.
size_t clustersAround(const ClusterTiles& tiles, const Reach& reach, double margin)
{
    const auto [firstSlice, lastSlice] = tiles.slicesOf(reach);
    size_t count = 0;
    for (int slice = firstSlice; slice < lastSlice; ++slice) {
        const auto met = [&](const TileAxis& axis, double at) {
            const auto [first, last] = axis.metBy(at - reach.radius, at + reach.radius, margin);
            return static_cast<size_t>(std::max(0, last - first));
        };
        count += met(tiles[slice].columns, reach.centre.x) * met(tiles[slice].rows, reach.centre.y);
    }
    return count;
}

}  // namespace

void setWork(const LightClusters& clusters, const ClusterTiles& tiles,
             const std::vector<Reach>& reaches, Workers& workers, ClusterWork& work)
{
    const ClusterGrid& grid = clusters.grid;
    const size_t lights = clusters.lights.size(),
                 first = kVectorsPerSlice * static_cast<size_t>(grid.slices);
    const double margin = kTileMargin + kTileSlack * std::max(grid.columns, grid.rows);
    work.tileMargin = static_cast<float>(margin);
    work.vectors.assign(first + kVectorsPerReach * lights, glm::vec4(0.0f));
    for (int slice = 0; slice < grid.slices; ++slice) {
        glm::vec4* const vectors = &work.vectors[kVectorsPerSlice * static_cast<size_t>(slice)];
        vectors[0] =
            glm::vec4(glm::dvec4(tiles[slice].distance.low, tiles[slice].distance.high, 0.0, 0.0));
        vectors[1] = glm::vec4(tiles[slice].columns.lines);
        vectors[2] = glm::vec4(tiles[slice].rows.lines);
    }
    const auto everywhere = static_cast<size_t>(clusters.everywhere);
    std::vector<size_t> counts((lights + kLightsPerTask - 1) / kLightsPerTask);
    workers.run(counts.size(), [&](size_t task) {
        const size_t end = std::min(lights, (task + 1) * kLightsPerTask);
        for (size_t i = std::max(everywhere, task * kLightsPerTask); i < end; ++i) {
            const Reach reach = widened(reaches[static_cast<size_t>(clusters.places[i])]);
            setVectors(reach, &work.vectors[first + kVectorsPerReach * i]);
            // Twice the margin: rounding stays below one.
            counts[task] += clustersAround(tiles, reach, 2.0 * margin);
        }
    });
    work.mostEntries = lights - everywhere;
    for (const size_t count : counts) work.mostEntries += count;
}

}  // namespace fbrdf

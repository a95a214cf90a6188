#include "ClusterTiles.h"

#include <cmath>

namespace fbrdf {
namespace {

// The end of the last slice: far beyond any scene, and its square is finite.
constexpr double kFarthest = 1e30;

/// The distances that a slice spans; the first slice reaches to the eye and the last has no end.
DistanceRange<double> spanOf(const LightClusters& clusters, int slice)
{
    const double scale = static_cast<double>(clusters.sliceScale),
                 bias = static_cast<double>(clusters.sliceBias);
    const bool isLast = slice + 1 == clusters.grid.slices;
    return {slice == 0 ? 0.0 : std::exp2((slice - bias) / scale),
            isLast ? kFarthest : std::exp2((slice + 1 - bias) / scale)};
}

TileAxis axisOf(const glm::dmat4& p, int axis, int count, const DistanceRange<double>& distance)
{
    // The eye coordinate of a normalised device coordinate at z is (ndc w - offset) / scale.
    const auto lineAt = [&](double z) {
        const double w = p[2][3] * z + p[3][3], offset = p[2][axis] * z + p[3][axis],
                     scale = p[axis][axis];
        return glm::dvec2((-w - offset) / scale, 2.0 * w / (count * scale));
    };
    TileAxis result;
    result.lines = glm::dvec4(lineAt(-distance.low), lineAt(-distance.high));
    result.perNear = 1.0 / result.lines.y;
    result.perFar = 1.0 / result.lines.w;
    result.mostPer = std::max(std::abs(result.perNear), std::abs(result.perFar));
    result.farthest = std::max(std::abs(result.lines.x), std::abs(result.lines.z));
    for (int i = 0; i < count; ++i) {
        const auto extent = tileExtent(result.lines, static_cast<double>(i), kTileMargin);
        result.lows.push_back(extent.low);
        result.highs.push_back(extent.high);
        result.farthest =
            std::max(result.farthest, std::max(std::abs(extent.low), std::abs(extent.high)));
        result.floatLows.push_back(static_cast<float>(extent.low));
        result.floatHighs.push_back(static_cast<float>(extent.high));
    }
    for (std::vector<float>* floats : {&result.floatLows, &result.floatHighs})
        floats->insert(floats->end(), kFloatsAtOnce, 0.0f);
    return result;
}

}  // namespace

DistanceRange<double> distanceOf(const Reach& reach)
{
    return {-reach.centre.z - reach.radius, -reach.centre.z + reach.radius};
}

DistanceRange<double> withSlack(const DistanceRange<double>& distance)
{
    const double slack =
        (kDistanceMargin - 1.0) * (std::abs(distance.low) + std::abs(distance.high));
    return {distance.low - slack, distance.high + slack};
}

ClusterTiles::ClusterTiles(const LightClusters& clusters, const glm::dmat4& projection,
                           const DistanceRange<double>& reach)
{
    for (int slice = 0; slice < clusters.grid.slices; ++slice) {
        const DistanceRange<double> span = spanOf(clusters, slice);
        lows_.push_back(span.low / kDistanceMargin);
        highs_.push_back(span.high * kDistanceMargin);
        Tiles tiles;
        tiles.distance = {std::max(lows_.back(), std::max(reach.low, 0.0)),
                          std::min(highs_.back(), reach.high)};
        tiles.columns = axisOf(projection, 0, clusters.grid.columns, tiles.distance);
        tiles.rows = axisOf(projection, 1, clusters.grid.rows, tiles.distance);
        slices_.push_back(std::move(tiles));
    }
}

std::pair<int, int> ClusterTiles::slicesOf(const Reach& reach) const
{
    const DistanceRange<double> distance = withSlack(distanceOf(reach));
    // Few slices are searched sooner one by one than by halves.
    size_t first = 0, last = slices_.size();
    while (first < last && highs_[first] < distance.low) ++first;
    while (first < last && lows_[last - 1] > distance.high) --last;
    return {static_cast<int>(first), static_cast<int>(last)};
}

int sliceOf(const LightClusters& clusters, double distance)
{
    const double slice =
        std::log2(std::max(distance, kNearest)) * static_cast<double>(clusters.sliceScale) +
        static_cast<double>(clusters.sliceBias);
    return static_cast<int>(std::clamp(std::floor(slice), 0.0, clusters.grid.slices - 1.0));
}

}  // namespace fbrdf

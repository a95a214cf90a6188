#include "ClusterGrid.h"

#include "ClusterTiles.h"

#include <cmath>

namespace fbrdf {
namespace {

constexpr double kStepsAnOctave = 16.0;       // of radii: tiles are up to 2 % larger or smaller
constexpr double kStepOfRadius = 1.0 / 64.0;  // of distances: less than a slice

/// Expects x > 0.
double nearestStep(double x)
{
    return std::exp2(std::round(kStepsAnOctave * std::log2(x)) / kStepsAnOctave);
}

/// From kNearest on; slices finer than 1 % of the depth would separate no lights.
DistanceRange<double> slicedRange(const DistanceRange<double>& reached)
{
    const double high = std::max(reached.high, kNearest);
    return {std::clamp(reached.low, 0.01 * high, 0.99 * high), high};
}

}  // namespace

void ReachSums::add(const Reach& reach, const glm::dmat4& projection)
{
    const DistanceRange<double> of = distanceOf(reach);
    distance.low = std::min(distance.low, of.low);
    distance.high = std::max(distance.high, of.high);
    const double w = std::abs(projection[2][3] * reach.centre.z + projection[3][3]),
                 scale = reach.radius / std::max(w, reach.radius * std::abs(projection[2][3]));
    radius += reach.radius;
    projected += scale * glm::dvec2(std::abs(projection[0][0]), std::abs(projection[1][1]));
    ++count;
}

void ReachSums::add(const ReachSums& other)
{
    distance.low = std::min(distance.low, other.distance.low);
    distance.high = std::max(distance.high, other.distance.high);
    radius += other.radius;
    projected += other.projected;
    count += other.count;
}

bool ReachSums::operator==(const ReachSums& other) const
{
    return distance.low == other.distance.low && distance.high == other.distance.high &&
           radius == other.radius && projected == other.projected && count == other.count;
}

ReachSums rounded(const ReachSums& sums)
{
    if (sums.count == 0) return {};
    ReachSums result;
    result.radius = nearestStep(sums.radius / sums.count);
    const double step = kStepOfRadius * result.radius;
    result.distance = {step * std::floor(sums.distance.low / step),
                       step * std::ceil(sums.distance.high / step)};
    result.projected = {nearestStep(sums.projected.x / sums.count),
                        nearestStep(sums.projected.y / sums.count)};
    result.count = 1;
    return result;
}

DistanceRange<double> setGrid(LightClusters& clusters, const ReachSums& sums)
{
    constexpr double kMostTiles = 96.0, kMostSlices = 24.0, kTilesPerRadius = 4.0,
                     kSlicesPerRadius = 1.5;
    // What is uploaded for each draw: 256 KB.
    constexpr double kMostClusters = 32768.0;
    const auto tiles = [&](double projected) {
        const double wanted = projected > 0.0 ? 2.0 * kTilesPerRadius / projected : 1.0;
        return static_cast<int>(std::clamp(std::ceil(wanted), 1.0, kMostTiles));
    };
    const DistanceRange<double> range = slicedRange(sums.distance);
    ClusterGrid& grid = clusters.grid;
    const double middle = std::sqrt(range.low * range.high),
                 wanted = sums.radius > 0.0
                              ? std::log(range.high / range.low) /
                                    std::log1p(sums.radius / (kSlicesPerRadius * middle))
                              : 1.0;
    if (grid.slices == 0)
        grid.slices = static_cast<int>(std::clamp(std::ceil(wanted), 1.0, kMostSlices));
    const int columns = tiles(sums.projected.x), rows = tiles(sums.projected.y);
    const double fewer =
        std::sqrt(std::min(1.0, kMostClusters / (double(columns) * rows * grid.slices)));
    if (grid.columns == 0) grid.columns = std::max(1, static_cast<int>(columns * fewer));
    if (grid.rows == 0) grid.rows = std::max(1, static_cast<int>(rows * fewer));
    const double scale = grid.slices / std::log2(range.high / range.low);
    clusters.sliceScale = static_cast<float>(scale);
    clusters.sliceBias = static_cast<float>(-scale * std::log2(range.low));
    return range;
}

}  // namespace fbrdf

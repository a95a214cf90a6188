#include "LightReach.h"

#include <fbrdf/plan/LightClusters.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace fbrdf {
namespace {

// The end of the last slice: far beyond any scene, and its square is finite.
constexpr double kFarthest = 1e30;

struct Interval {
    double low = 0.0, high = 0.0;
    double distanceTo(double x) const { return std::max({low - x, x - high, 0.0}); }
};

/// The distances from the eye that a sphere spans.
Interval distanceOf(const Reach& reach)
{
    return {-reach.centre.z - reach.radius, -reach.centre.z + reach.radius};
}

int sliceOf(const LightClusters& clusters, double distance)
{
    const double slice =
        std::log2(std::max(distance, kNearest)) * static_cast<double>(clusters.sliceScale) +
        static_cast<double>(clusters.sliceBias);
    return static_cast<int>(std::clamp(std::floor(slice), 0.0, clusters.grid.slices - 1.0));
}

/// The distances that a slice spans; the first slice reaches to the eye and the last has no end.
Interval spanOf(const LightClusters& clusters, int slice)
{
    const double scale = static_cast<double>(clusters.sliceScale),
                 bias = static_cast<double>(clusters.sliceBias);
    const bool isLast = slice + 1 == clusters.grid.slices;
    return {slice == 0 ? 0.0 : std::exp2((slice - bias) / scale),
            isLast ? kFarthest : std::exp2((slice + 1 - bias) / scale)};
}

/// The eye coordinate (axis 0: x, 1: y) of a normalised device coordinate at z.
double eyeCoordinate(const glm::dmat4& p, int axis, double ndc, double z)
{
    const double w = p[2][3] * z + p[3][3];
    return (ndc * w - p[2][axis] * z - p[3][axis]) / p[axis][axis];
}

/// The extent of tile `index` of `count` along an axis, over a range of distances. The margin is
/// far above the float rounding of the shader's pixel coordinates.
Interval extentOf(const glm::dmat4& projection, int axis, int index, int count,
                  const Interval& distance)
{
    constexpr double kMargin = 1e-4;
    Interval result{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    for (const double z : {-distance.low, -distance.high})
        for (const double edge : {index - kMargin, index + 1 + kMargin}) {
            const double x = eyeCoordinate(projection, axis, 2.0 * edge / count - 1.0, z);
            result.low = std::min(result.low, x);
            result.high = std::max(result.high, x);
        }
    return result;
}

double squared(double x)
{
    return x * x;
}

/// The tiles of a slice in eye space, ascending along each axis.
struct Tiles {
    Interval distance;
    std::vector<Interval> columns, rows;
};

std::vector<Interval> extentsOf(const glm::dmat4& projection, int axis, int count,
                                const Interval& distance)
{
    std::vector<Interval> extents;
    for (int i = 0; i < count; ++i)
        extents.push_back(extentOf(projection, axis, i, count, distance));
    return extents;
}

/// reach: the distances that lights with a radius reach; the outer slices end there.
Tiles tilesOf(const LightClusters& clusters, const glm::dmat4& projection, const Interval& reach,
              int slice)
{
    constexpr double kMargin = 1.0 + 1e-5;  // far above the rounding of the shader's float distance
    Tiles tiles;
    tiles.distance = spanOf(clusters, slice);
    tiles.distance.low = std::max(tiles.distance.low / kMargin, std::max(reach.low, 0.0));
    tiles.distance.high = std::min(tiles.distance.high * kMargin, reach.high);
    tiles.columns = extentsOf(projection, 0, clusters.grid.columns, tiles.distance);
    tiles.rows = extentsOf(projection, 1, clusters.grid.rows, tiles.distance);
    return tiles;
}

/// The range [first, last) of ascending extents that [centre - radius, centre + radius] meets.
std::pair<int, int> metBy(const std::vector<Interval>& extents, double centre, double radius)
{
    const auto first =
        std::partition_point(extents.begin(), extents.end(),
                             [=](const Interval& extent) { return extent.high < centre - radius; });
    const auto last = std::partition_point(first, extents.end(), [=](const Interval& extent) {
        return extent.low <= centre + radius;
    });
    return {static_cast<int>(first - extents.begin()), static_cast<int>(last - extents.begin())};
}

/// Calls visit(column, row) for every tile of a slice that the sphere meets.
template <class Visit>
void forEachMet(const Tiles& tiles, const Reach& reach, Visit visit)
{
    const double radius = reach.radius * (1.0 + 1e-5), radius2 = squared(radius),
                 z2 = squared(tiles.distance.distanceTo(-reach.centre.z));
    if (z2 > radius2 || tiles.distance.low > tiles.distance.high) return;
    const auto [firstRow, lastRow] = metBy(tiles.rows, reach.centre.y, radius);
    for (int row = firstRow; row < lastRow; ++row) {
        const double y2 =
            z2 + squared(tiles.rows[static_cast<size_t>(row)].distanceTo(reach.centre.y));
        if (y2 > radius2) continue;
        const auto [first, last] = metBy(tiles.columns, reach.centre.x, std::sqrt(radius2 - y2));
        for (int column = first; column < last; ++column) visit(column, row);
    }
}

struct Member {
    int32_t cluster, light;
};

/// The lights of each cluster, ascending in each. Lights without a radius that are not already
/// everywhere are in every cluster.
std::vector<Member> membersOf(const LightClusters& clusters, const glm::dmat4& projection,
                              const Interval& reach)
{
    const ClusterGrid& grid = clusters.grid;
    std::vector<Member> members;
    for (int slice = 0; slice < grid.slices; ++slice) {
        const Tiles tiles = tilesOf(clusters, projection, reach, slice);
        const auto clusterAt = [&grid, slice](int column, int row) {
            return (slice * grid.rows + row) * grid.columns + column;
        };
        for (size_t i = static_cast<size_t>(clusters.everywhere); i < clusters.lights.size(); ++i) {
            const auto light = static_cast<int32_t>(i);
            const auto visit = [&](int column, int row) {
                members.push_back({clusterAt(column, row), light});
            };
            if (!isUnlimited(clusters.lights[i])) {
                forEachMet(tiles, reachOf(clusters.lights[i]), visit);
                continue;
            }
            for (int row = 0; row < grid.rows; ++row)
                for (int column = 0; column < grid.columns; ++column) visit(column, row);
        }
    }
    return members;
}

/// Sorts the members into the lists of their clusters, keeping their order.
void setLists(LightClusters& clusters, const std::vector<Member>& members)
{
    auto& lists = clusters.lists;
    lists.assign(2 * static_cast<size_t>(clusters.grid.count()), 0);
    for (const Member& member : members) ++lists[2 * static_cast<size_t>(member.cluster) + 1];
    int32_t first = 0;
    for (size_t k = 0; k < lists.size(); k += 2) {
        lists[k] = first;
        first += lists[k + 1];
        lists[k + 1] = 0;
    }
    clusters.indices.resize(members.size());
    for (const Member& member : members) {
        int32_t* const list = &lists[2 * static_cast<size_t>(member.cluster)];
        clusters.indices[static_cast<size_t>(list[0] + list[1]++)] = member.light;
    }
}

/// An upper bound of the irradiance that a light causes in a box, as strongestIrradiance but
/// without the cone.
double strongestIn(const LightVectors& light, const Interval (&box)[3])
{
    const double mean = glm::dot(Vec3d(light[1]), Vec3d(1.0)) / 3.0;
    if (light[1].w == 0.0f) return mean;
    const Vec3d at(light[0]);
    const double d2 = squared(box[0].distanceTo(at.x)) + squared(box[1].distanceTo(at.y)) +
                      squared(box[2].distanceTo(-at.z));
    return mean * falloff(d2, isUnlimited(light) ? 0.0 : influenceRadius(light));
}

/// Shortens every list to its strongest lights, which stay ascending.
void keepStrongest(LightClusters& clusters, const glm::dmat4& projection, const Interval& reach,
                   int most)
{
    const ClusterGrid& grid = clusters.grid;
    for (int slice = 0; slice < grid.slices; ++slice) {
        const Tiles tiles = tilesOf(clusters, projection, reach, slice);
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column) {
                int32_t* const list =
                    &clusters.lists[2 * static_cast<size_t>(
                                            (slice * grid.rows + row) * grid.columns + column)];
                if (list[1] <= most) continue;
                const Interval box[3] = {tiles.columns[static_cast<size_t>(column)],
                                         tiles.rows[static_cast<size_t>(row)], tiles.distance};
                std::vector<std::pair<double, int32_t>> ranked;
                const auto first = clusters.indices.begin() + list[0];
                for (auto i = first; i != first + list[1]; ++i)
                    ranked.emplace_back(-strongestIn(clusters.lights[static_cast<size_t>(*i)], box),
                                        *i);
                std::nth_element(ranked.begin(), ranked.begin() + most, ranked.end());
                std::transform(ranked.begin(), ranked.begin() + most, first,
                               [](const auto& one) { return one.second; });
                std::sort(first, first + most);
                clusters.dropped = std::max(clusters.dropped, list[1] - most);
                list[1] = most;
            }
    }
}

/// The distances from the eye that lights with a radius reach, from kNearest on.
Interval reachedBy(const LightClusters& clusters)
{
    Interval range{std::numeric_limits<double>::max(), 0.0};
    for (const LightVectors& light : clusters.lights) {
        if (isUnlimited(light)) continue;
        const Interval distance = distanceOf(reachOf(light));
        range.low = std::min(range.low, distance.low);
        range.high = std::max(range.high, distance.high);
    }
    range.high = std::max(range.high, kNearest);
    // Slices finer than 1 % of the depth would separate no lights.
    range.low = std::clamp(range.low, 0.01 * range.high, 0.99 * range.high);
    return range;
}

/// The mean radius of the lights that have one, in eye space and in normalised device coordinates.
struct Means {
    double radius = 0.0;
    glm::dvec2 projected{0.0};
};

Means meansOf(const LightClusters& clusters, const glm::dmat4& projection)
{
    Means sum;
    int count = 0;
    for (const LightVectors& light : clusters.lights) {
        if (isUnlimited(light)) continue;
        const Reach reach = reachOf(light);
        const double w = std::abs(projection[2][3] * reach.centre.z + projection[3][3]),
                     scale = reach.radius / std::max(w, reach.radius * std::abs(projection[2][3]));
        sum.radius += reach.radius;
        sum.projected += scale * glm::dvec2(projection[0][0], projection[1][1]);
        ++count;
    }
    return count == 0 ? sum : Means{sum.radius / count, sum.projected / double(count)};
}

/// Chooses the numbers of tiles and slices that the caller left at 0.
void setGrid(LightClusters& clusters, const glm::dmat4& projection, const Interval& range)
{
    constexpr double kMostTiles = 32.0, kMostSlices = 24.0, kTilesPerRadius = 4.0,
                     kSlicesPerRadius = 1.5;
    const Means means = meansOf(clusters, projection);
    const auto tiles = [&](double projected) {
        const double wanted = projected != 0.0 ? 2.0 * kTilesPerRadius / std::abs(projected) : 1.0;
        return static_cast<int>(std::clamp(std::ceil(wanted), 1.0, kMostTiles));
    };
    ClusterGrid& grid = clusters.grid;
    if (grid.columns == 0) grid.columns = tiles(means.projected.x);
    if (grid.rows == 0) grid.rows = tiles(means.projected.y);
    const double middle = std::sqrt(range.low * range.high),
                 wanted = means.radius > 0.0
                              ? std::log(range.high / range.low) /
                                    std::log1p(means.radius / (kSlicesPerRadius * middle))
                              : 1.0;
    if (grid.slices == 0)
        grid.slices = static_cast<int>(std::clamp(std::ceil(wanted), 1.0, kMostSlices));
    const double scale = grid.slices / std::log2(range.high / range.low);
    clusters.sliceScale = static_cast<float>(scale);
    clusters.sliceBias = static_cast<float>(-scale * std::log2(range.low));
}

/// Sets the lights, those without a radius first unless they stand in lists.
void setLights(LightClusters& clusters, const std::vector<LightVectors>& lights, bool inLists)
{
    const auto at = [&lights](int32_t place) -> const LightVectors& {
        return lights[static_cast<size_t>(place)];
    };
    auto& places = clusters.places;
    places.resize(lights.size());
    std::iota(places.begin(), places.end(), 0);
    if (!inLists) {
        const auto limited = std::stable_partition(
            places.begin(), places.end(), [&at](int32_t place) { return isUnlimited(at(place)); });
        clusters.everywhere = static_cast<int>(limited - places.begin());
    }
    std::transform(places.begin(), places.end(), std::back_inserter(clusters.lights), at);
}

}  // namespace

LightClusters lightClusters(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                            const ClusterGrid& grid, int mostPerList)
{
    LightClusters clusters;
    clusters.grid = grid;
    setLights(clusters, lights, mostPerList > 0);
    const Interval range = reachedBy(clusters);
    setGrid(clusters, projection, range);
    setLists(clusters, membersOf(clusters, projection, range));
    if (mostPerList > 0) keepStrongest(clusters, projection, range, mostPerList);
    for (size_t k = 1; k < clusters.lists.size(); k += 2)
        clusters.longest = std::max(clusters.longest, clusters.everywhere + clusters.lists[k]);
    return clusters;
}

LightList lightList(const LightClusters& clusters, const glm::dvec2& ndc, double distance)
{
    const ClusterGrid& grid = clusters.grid;
    const auto tile = [](double x, int count) {
        return std::clamp(static_cast<int>(std::floor((0.5 * x + 0.5) * count)), 0, count - 1);
    };
    const int cluster =
        (sliceOf(clusters, distance) * grid.rows + tile(ndc.y, grid.rows)) * grid.columns +
        tile(ndc.x, grid.columns);
    const auto at = 2 * static_cast<size_t>(cluster);
    return {clusters.lists[at], clusters.lists[at + 1]};
}

}  // namespace fbrdf

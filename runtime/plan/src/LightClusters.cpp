#include <fbrdf/plan/LightClusters.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace fbrdf {
namespace {

// Distances below count as this; far below any near plane, so that log2 stays finite.
constexpr double kNearest = 1e-6;

struct Interval {
    double low = 0.0, high = 0.0;
    double distanceTo(double x) const { return std::max({low - x, x - high, 0.0}); }
};

struct Reach {
    Vec3d centre;
    double radius;
    Interval distance() const { return {-centre.z - radius, -centre.z + radius}; }
};

Reach reachOf(const LightVectors& light)
{
    return {Vec3d(light[0]), 1.0 / std::sqrt(static_cast<double>(light[1].w))};
}

bool isUnlimited(const LightVectors& light)
{
    return light[1].w == 0.0f;
}

int sliceOf(const LightClusters& clusters, double distance)
{
    const double slice =
        std::log2(std::max(distance, kNearest)) * static_cast<double>(clusters.sliceScale) +
        static_cast<double>(clusters.sliceBias);
    return static_cast<int>(std::clamp(std::floor(slice), 0.0, clusters.grid.slices - 1.0));
}

/// What a slice spans; the first and the last reach to the eye and without end.
Interval spanOf(const LightClusters& clusters, int slice)
{
    const double scale = static_cast<double>(clusters.sliceScale),
                 bias = static_cast<double>(clusters.sliceBias);
    const bool isLast = slice + 1 == clusters.grid.slices;
    return {slice == 0 ? 0.0 : std::exp2((slice - bias) / scale),
            isLast ? std::numeric_limits<double>::max() : std::exp2((slice + 1 - bias) / scale)};
}

/// Eye coordinate (axis 0: x, 1: y) that a normalised device coordinate means at z.
double eyeCoordinate(const glm::dmat4& p, int axis, double ndc, double z)
{
    const double w = p[2][3] * z + p[3][3];
    return (ndc * w - p[2][axis] * z - p[3][axis]) / p[axis][axis];
}

/// Of tile `index` of `count` along an axis, over distances [near, far]. Float rounding of the
/// shader's pixel coordinates is far below the margin.
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

/// Calls visit(cluster) for every cluster that the sphere meets.
template <class Visit>
void forEachMet(const LightClusters& clusters, const glm::dmat4& projection, const Reach& reach,
                Visit visit)
{
    const ClusterGrid& grid = clusters.grid;
    const Interval all = reach.distance();
    if (all.high < 0.0) return;
    constexpr double kMargin = 1.0 + 1e-5;  // of the float that the shader's distance is
    const double radius2 = squared(reach.radius * kMargin);
    for (int slice = sliceOf(clusters, all.low); slice <= sliceOf(clusters, all.high); ++slice) {
        Interval span = spanOf(clusters, slice);
        span.low = std::max(span.low / kMargin, all.low);
        span.high = std::min(span.high * kMargin, all.high);
        const double z2 = squared(span.distanceTo(-reach.centre.z));
        for (int row = 0; row < grid.rows; ++row) {
            const double y2 =
                z2 +
                squared(extentOf(projection, 1, row, grid.rows, span).distanceTo(reach.centre.y));
            if (y2 > radius2) continue;
            for (int column = 0; column < grid.columns; ++column)
                if (y2 + squared(extentOf(projection, 0, column, grid.columns, span)
                                     .distanceTo(reach.centre.x)) <=
                    radius2)
                    visit((slice * grid.rows + row) * grid.columns + column);
        }
    }
}

/// Slices between the nearest and the farthest distance that lights with a radius reach.
void setSlices(LightClusters& clusters)
{
    Interval range{std::numeric_limits<double>::max(), 0.0};
    for (size_t i = static_cast<size_t>(clusters.everywhere); i < clusters.lights.size(); ++i) {
        const Interval distance = reachOf(clusters.lights[i]).distance();
        range.low = std::min(range.low, distance.low);
        range.high = std::max(range.high, distance.high);
    }
    // Slices finer than 1 % of the depth serve nobody.
    range.high = std::max(range.high, kNearest);
    range.low = std::clamp(range.low, 0.01 * range.high, 0.99 * range.high);
    const double scale = clusters.grid.slices / std::log2(range.high / range.low);
    clusters.sliceScale = static_cast<float>(scale);
    clusters.sliceBias = static_cast<float>(-scale * std::log2(range.low));
}

}  // namespace

LightClusters lightClusters(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                            const ClusterGrid& grid)
{
    LightClusters clusters;
    clusters.grid = grid;
    const auto at = [&lights](int32_t place) -> const LightVectors& {
        return lights[static_cast<size_t>(place)];
    };
    auto& places = clusters.places;
    places.resize(lights.size());
    std::iota(places.begin(), places.end(), 0);
    const auto limited = std::stable_partition(
        places.begin(), places.end(), [&at](int32_t place) { return isUnlimited(at(place)); });
    clusters.everywhere = static_cast<int>(limited - places.begin());
    std::transform(places.begin(), places.end(), std::back_inserter(clusters.lights), at);
    setSlices(clusters);
    std::vector<std::vector<int32_t>> lists(static_cast<size_t>(grid.count()));
    for (int i = clusters.everywhere; i < static_cast<int>(lights.size()); ++i)
        forEachMet(clusters, projection, reachOf(clusters.lights[static_cast<size_t>(i)]),
                   [&](int cluster) { lists[static_cast<size_t>(cluster)].push_back(i); });
    size_t longest = 0;
    for (const auto& list : lists) {
        clusters.lists.push_back(static_cast<int32_t>(clusters.indices.size()));
        clusters.lists.push_back(static_cast<int32_t>(list.size()));
        clusters.indices.insert(clusters.indices.end(), list.begin(), list.end());
        longest = std::max(longest, list.size());
    }
    clusters.longest = clusters.everywhere + static_cast<int>(longest);
    return clusters;
}

PixelRect pixelBounds(const LightVectors& light, const glm::dmat4& projection, int width,
                      int height)
{
    const PixelRect whole{0, 0, width, height};
    if (isUnlimited(light)) return whole;
    const Reach reach = reachOf(light);
    glm::dvec2 low(std::numeric_limits<double>::max()), high(-low);
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const glm::dvec4 clip = projection * glm::dvec4(reach.centre + reach.radius * sign, 1.0);
        if (!(clip.w > kNearest)) return whole;
        low = glm::min(low, glm::dvec2(clip) / clip.w);
        high = glm::max(high, glm::dvec2(clip) / clip.w);
    }
    const glm::dvec2 size(width, height);
    const glm::dvec2 first = glm::clamp(glm::floor((low * 0.5 + 0.5) * size) - 1.0, {}, size),
                     last = glm::clamp(glm::ceil((high * 0.5 + 0.5) * size) + 1.0, {}, size);
    return {static_cast<int>(first.x), static_cast<int>(first.y),
            static_cast<int>(last.x - first.x), static_cast<int>(last.y - first.y)};
}

}  // namespace fbrdf

#include "LightReach.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Parallel.h>
#include <fbrdf/plan/LightClusters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace fbrdf {

/// What is needed while lists are made, kept because so much memory costs more than filling it.
struct ClusterBuilder::Scratch {
    /// A light in neighbouring tiles of a row: [first, last).
    struct Span {
        int32_t light;
        int16_t row, first, last;
    };

    /// Rows [first, last) of the tiles of a slice, which one task fills.
    struct Band {
        int slice = 0, first = 0, last = 0;
    };

    std::vector<Reach> all, reaches;  ///< of the lights that were given, and of those that are seen
    std::vector<char> seen;
    /// The slices [first, second) that each light may be in.
    std::vector<std::pair<int, int>> ranges;
    /// The lights that may be in each slice, ascending: those of slice s are ofSlices[firsts[s]] to
    /// ofSlices[firsts[s + 1]].
    std::vector<size_t> firsts;
    std::vector<int32_t> ofSlices;
    /// For each band its spans, how many lights each of its tiles has, and the sum of these
    /// numbers.
    struct OfBand {
        Band band;
        std::vector<Span> spans;
        std::vector<int32_t> differences, counts, next;
        size_t total = 0, first = 0;
    };
    std::vector<OfBand> bands;
};

namespace {

using Scratch = ClusterBuilder::Scratch;
using Span = Scratch::Span;
using Band = Scratch::Band;

// The end of the last slice: far beyond any scene, and its square is finite.
constexpr double kFarthest = 1e30;
// Far above the rounding of the shader's float distances.
constexpr double kDistanceMargin = 1.0 + 1e-5;
// Starting a thread costs as much as the lists of some hundred lights, each counted once for every
// slice.
constexpr size_t kFewLights = 1024;
constexpr int kMostThreads = 4;
constexpr int kMostOnASide = std::numeric_limits<int16_t>::max();  // of a span

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

double squared(double x)
{
    return x * x;
}

/// The tiles along one axis of a slice. Their edges lie on a line at the near end of the slice and
/// on another at the far end: x = origin + step x edge, edge = 0 .. count.
struct TileAxis {
    struct Line {
        double origin = 0.0, step = 0.0, perUnit = 0.0;  ///< perUnit: 1 / step
        double at(double edge) const { return origin + step * edge; }
        double edgeAt(double x) const { return (x - origin) * perUnit; }
    };
    Line nearEnd, farEnd;
    std::vector<Interval> extents;

    /// False for mirrored or degenerate projections: then only a tile's own extent tells.
    bool ascends() const { return nearEnd.step > 0.0 && farEnd.step > 0.0; }

    /// The range [first, last) of tiles that [low, high] meets.
    std::pair<int, int> metBy(double low, double high) const
    {
        const auto count = static_cast<double>(extents.size());
        if (!ascends()) return {0, static_cast<int>(extents.size())};
        const double first = std::min(nearEnd.edgeAt(low), farEnd.edgeAt(low)) - kMargin,
                     last = std::max(nearEnd.edgeAt(high), farEnd.edgeAt(high)) + kMargin;
        // Conversions to int round towards 0, which for what is not negative is down.
        return {static_cast<int>(std::clamp(first, 0.0, count)),
                static_cast<int>(std::clamp(last + 1.0, 0.0, count))};
    }

    // Of a tile: far above the float rounding of the shader's pixel coordinates.
    static constexpr double kMargin = 1e-4;
};

TileAxis axisOf(const glm::dmat4& p, int axis, int count, const Interval& distance)
{
    // The eye coordinate of a normalised device coordinate at z is (ndc w - offset) / scale.
    const auto lineAt = [&](double z) {
        const double w = p[2][3] * z + p[3][3], offset = p[2][axis] * z + p[3][axis],
                     scale = p[axis][axis];
        const double step = 2.0 * w / (count * scale);
        return TileAxis::Line{(-w - offset) / scale, step, 1.0 / step};
    };
    TileAxis result{lineAt(-distance.low), lineAt(-distance.high), {}};
    for (int i = 0; i < count; ++i) {
        Interval extent{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
        for (const TileAxis::Line& line : {result.nearEnd, result.farEnd})
            for (const double edge : {i - TileAxis::kMargin, i + 1 + TileAxis::kMargin}) {
                extent.low = std::min(extent.low, line.at(edge));
                extent.high = std::max(extent.high, line.at(edge));
            }
        result.extents.push_back(extent);
    }
    return result;
}

/// The tiles of a slice in eye space.
struct Tiles {
    Interval distance;
    TileAxis columns, rows;
};

/// reach: the distances that lights with a radius reach; the outer slices end there.
Tiles tilesOf(const LightClusters& clusters, const glm::dmat4& projection, const Interval& reach,
              int slice)
{
    Tiles tiles;
    tiles.distance = spanOf(clusters, slice);
    tiles.distance.low = std::max(tiles.distance.low / kDistanceMargin, std::max(reach.low, 0.0));
    tiles.distance.high = std::min(tiles.distance.high * kDistanceMargin, reach.high);
    tiles.columns = axisOf(projection, 0, clusters.grid.columns, tiles.distance);
    tiles.rows = axisOf(projection, 1, clusters.grid.rows, tiles.distance);
    return tiles;
}

/// Drops tiles at either end that [x - half, x + half] does not meet.
void trim(const TileAxis& axis, double x, double half, int& first, int& last)
{
    const auto isMet = [&](int tile) {
        return axis.extents[static_cast<size_t>(tile)].distanceTo(x) <= half;
    };
    while (first < last && !isMet(first)) ++first;
    while (first < last && !isMet(last - 1)) --last;
}

/// Appends the tiles of a band that the sphere meets.
void addSpans(const Tiles& tiles, const Band& band, int32_t light, const Reach& reach,
              std::vector<Span>& spans)
{
    const double radius = reach.radius * kDistanceMargin, radius2 = squared(radius),
                 z2 = squared(tiles.distance.distanceTo(-reach.centre.z));
    if (z2 > radius2 || tiles.distance.low > tiles.distance.high) return;
    const double x = reach.centre.x, y = reach.centre.y;
    const auto [firstRow, lastRow] = tiles.rows.metBy(y - radius, y + radius);
    for (int row = std::max(firstRow, band.first); row < std::min(lastRow, band.last); ++row) {
        const double left =
            radius2 - z2 - squared(tiles.rows.extents[static_cast<size_t>(row)].distanceTo(y));
        if (left < 0.0) continue;
        const double half = std::sqrt(left);
        auto [first, last] = tiles.columns.metBy(x - half, x + half);
        if (!tiles.columns.ascends()) trim(tiles.columns, x, half, first, last);
        if (first < last)
            spans.push_back({light, static_cast<int16_t>(row), static_cast<int16_t>(first),
                             static_cast<int16_t>(last)});
    }
}

int threadsFor(size_t work)
{
    return work < kFewLights ? 1 : std::min(threadCount(0), kMostThreads);
}

void setLightsOfSlices(const LightClusters& clusters, Scratch& scratch)
{
    const auto everywhere = static_cast<size_t>(clusters.everywhere);
    const size_t count = clusters.lights.size();
    scratch.ranges.resize(count);
    scratch.firsts.assign(static_cast<size_t>(clusters.grid.slices) + 1, 0);
    for (size_t i = everywhere; i < count; ++i) {
        auto& range = scratch.ranges[i];
        range = {0, clusters.grid.slices};
        if (!isUnlimited(clusters.lights[i])) {
            const Interval distance = distanceOf(scratch.reaches[i]);
            const double slack =
                (kDistanceMargin - 1.0) * (std::abs(distance.low) + std::abs(distance.high));
            range = {sliceOf(clusters, (distance.low - slack) / kDistanceMargin),
                     sliceOf(clusters, (distance.high + slack) * kDistanceMargin) + 1};
        }
        for (int slice = range.first; slice < range.second; ++slice)
            ++scratch.firsts[static_cast<size_t>(slice) + 1];
    }
    std::partial_sum(scratch.firsts.begin(), scratch.firsts.end(), scratch.firsts.begin());
    scratch.ofSlices.resize(scratch.firsts.back());
    std::vector<size_t> next(scratch.firsts.begin(), scratch.firsts.end() - 1);
    for (size_t i = everywhere; i < count; ++i)
        for (int slice = scratch.ranges[i].first; slice < scratch.ranges[i].second; ++slice)
            scratch.ofSlices[next[static_cast<size_t>(slice)]++] = static_cast<int32_t>(i);
}

/// Cuts slices into bands of rows until there are enough of them for all threads.
void setBands(const ClusterGrid& grid, std::vector<Scratch::OfBand>& bands)
{
    constexpr int kFewestBands = 4;
    const int pieces = std::clamp(kFewestBands / grid.slices, 1, grid.rows);
    bands.resize(static_cast<size_t>(grid.slices * pieces));
    for (int k = 0; k < grid.slices * pieces; ++k) {
        const int piece = k % pieces;
        bands[static_cast<size_t>(k)].band = {k / pieces, grid.rows * piece / pieces,
                                              grid.rows * (piece + 1) / pieces};
    }
}

/// Finds the spans of a band and counts the lights of its tiles.
void setSpans(const LightClusters& clusters, const Tiles& tiles, const Scratch& scratch,
              Scratch::OfBand& of)
{
    const Band& band = of.band;
    const auto slice = static_cast<size_t>(band.slice);
    of.spans.clear();
    for (size_t k = scratch.firsts[slice]; k < scratch.firsts[slice + 1]; ++k) {
        const int32_t light = scratch.ofSlices[k];
        if (!isUnlimited(clusters.lights[static_cast<size_t>(light)])) {
            addSpans(tiles, band, light, scratch.reaches[static_cast<size_t>(light)], of.spans);
            continue;
        }
        for (int row = band.first; row < band.last; ++row)
            of.spans.push_back(
                {light, static_cast<int16_t>(row), 0, static_cast<int16_t>(clusters.grid.columns)});
    }
    // Differences between neighbours first; their running sum are the numbers.
    const auto width = static_cast<size_t>(clusters.grid.columns) + 1,
               rows = static_cast<size_t>(band.last - band.first);
    of.differences.assign(width * rows, 0);
    for (const Span& span : of.spans) {
        int32_t* const row = &of.differences[width * static_cast<size_t>(span.row - band.first)];
        ++row[span.first];
        --row[span.last];
    }
    of.counts.clear();
    of.total = 0;
    for (size_t row = 0; row < rows; ++row) {
        int32_t count = 0;
        for (size_t column = 0; column + 1 < width; ++column) {
            count += of.differences[row * width + column];
            of.counts.push_back(count);
            of.total += static_cast<size_t>(count);
        }
    }
}

/// Writes the lists of a band, whose lights begin at index of.first.
void fillLists(LightClusters& clusters, Scratch::OfBand& of)
{
    const ClusterGrid& grid = clusters.grid;
    auto first = static_cast<int32_t>(of.first);
    const auto cluster =
        static_cast<size_t>((of.band.slice * grid.rows + of.band.first) * grid.columns);
    of.next.clear();
    for (size_t tile = 0; tile < of.counts.size(); ++tile) {
        clusters.lists[2 * (cluster + tile)] = first;
        clusters.lists[2 * (cluster + tile) + 1] = of.counts[tile];
        of.next.push_back(first);
        first += of.counts[tile];
    }
    for (const Span& span : of.spans) {
        int32_t* const row =
            &of.next[static_cast<size_t>((span.row - of.band.first) * grid.columns)];
        for (int column = span.first; column < span.last; ++column)
            clusters.indices[static_cast<size_t>(row[column]++)] = span.light;
    }
}

/// Makes the lists: the lights of each cluster, ascending. Bands share nothing, so threads make
/// them side by side.
void setLists(LightClusters& clusters, const glm::dmat4& projection, const Interval& range,
              Scratch& scratch)
{
    setLightsOfSlices(clusters, scratch);
    setBands(clusters.grid, scratch.bands);
    const int threads = threadsFor(scratch.ofSlices.size());
    parallelTasks(scratch.bands.size(), threads, [&](size_t k) {
        Scratch::OfBand& of = scratch.bands[k];
        setSpans(clusters, tilesOf(clusters, projection, range, of.band.slice), scratch, of);
    });
    size_t total = 0;
    for (Scratch::OfBand& of : scratch.bands) {
        of.first = total;
        total += of.total;
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
    parallelTasks(scratch.bands.size(), threads,
                  [&](size_t k) { fillLists(clusters, scratch.bands[k]); });
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
                const Interval box[3] = {tiles.columns.extents[static_cast<size_t>(column)],
                                         tiles.rows.extents[static_cast<size_t>(row)],
                                         tiles.distance};
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
Interval reachedBy(const LightClusters& clusters, const std::vector<Reach>& reaches)
{
    Interval range{std::numeric_limits<double>::max(), 0.0};
    for (size_t i = 0; i < reaches.size(); ++i) {
        if (isUnlimited(clusters.lights[i])) continue;
        const Interval distance = distanceOf(reaches[i]);
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

Means meansOf(const LightClusters& clusters, const std::vector<Reach>& reaches,
              const glm::dmat4& projection)
{
    Means sum;
    int count = 0;
    for (size_t i = 0; i < reaches.size(); ++i) {
        if (isUnlimited(clusters.lights[i])) continue;
        const Reach& reach = reaches[i];
        const double w = std::abs(projection[2][3] * reach.centre.z + projection[3][3]),
                     scale = reach.radius / std::max(w, reach.radius * std::abs(projection[2][3]));
        sum.radius += reach.radius;
        sum.projected += scale * glm::dvec2(projection[0][0], projection[1][1]);
        ++count;
    }
    return count == 0 ? sum : Means{sum.radius / count, sum.projected / double(count)};
}

/// Chooses the numbers of tiles and slices that the caller left at 0.
void setGrid(LightClusters& clusters, const std::vector<Reach>& reaches,
             const glm::dmat4& projection, const Interval& range)
{
    constexpr double kMostTiles = 96.0, kMostSlices = 24.0, kTilesPerRadius = 4.0,
                     kSlicesPerRadius = 1.5;
    // What is uploaded for each draw: 256 KB.
    constexpr double kMostClusters = 32768.0;
    const Means means = meansOf(clusters, reaches, projection);
    const auto tiles = [&](double projected) {
        const double wanted = projected != 0.0 ? 2.0 * kTilesPerRadius / std::abs(projected) : 1.0;
        return static_cast<int>(std::clamp(std::ceil(wanted), 1.0, kMostTiles));
    };
    ClusterGrid& grid = clusters.grid;
    const double middle = std::sqrt(range.low * range.high),
                 wanted = means.radius > 0.0
                              ? std::log(range.high / range.low) /
                                    std::log1p(means.radius / (kSlicesPerRadius * middle))
                              : 1.0;
    if (grid.slices == 0)
        grid.slices = static_cast<int>(std::clamp(std::ceil(wanted), 1.0, kMostSlices));
    const int columns = tiles(means.projected.x), rows = tiles(means.projected.y);
    const double fewer =
        std::sqrt(std::min(1.0, kMostClusters / (double(columns) * rows * grid.slices)));
    if (grid.columns == 0) grid.columns = std::max(1, static_cast<int>(columns * fewer));
    if (grid.rows == 0) grid.rows = std::max(1, static_cast<int>(rows * fewer));
    const double scale = grid.slices / std::log2(range.high / range.low);
    clusters.sliceScale = static_cast<float>(scale);
    clusters.sliceBias = static_cast<float>(-scale * std::log2(range.low));
}

/// The part of eye space that is seen: -w <= x <= w, -w <= y <= w, 0 <= w. Depth is left out, as
/// conventions of it differ.
class View {
public:
    explicit View(const glm::dmat4& projection)
    {
        const glm::dmat4 rows = glm::transpose(projection);
        const glm::dvec4 planes[] = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
                                     rows[3] - rows[1], rows[3]};
        for (size_t k = 0; k < planes_.size(); ++k) {
            const double length = glm::length(Vec3d(planes[k]));
            planes_[k] = length > 0.0 ? planes[k] / length : glm::dvec4(0.0, 0.0, 0.0, 1.0);
        }
    }

    /// True unless all of the sphere is certain to be outside.
    bool mayMeet(const Reach& reach) const
    {
        return std::all_of(planes_.begin(), planes_.end(), [&](const glm::dvec4& plane) {
            const double along = glm::dot(Vec3d(plane), reach.centre);
            const double slack = (kDistanceMargin - 1.0) * (std::abs(along) + std::abs(plane.w));
            return along + plane.w + slack >= -reach.radius * kDistanceMargin;
        });
    }

private:
    std::array<glm::dvec4, 5> planes_;
};

/// Sets the lights that can be seen, those without a radius first unless they stand in lists, and
/// their reaches.
void setLights(LightClusters& clusters, const std::vector<LightVectors>& lights,
               const glm::dmat4& projection, bool inLists, Scratch& scratch)
{
    const View view(projection);
    scratch.all.resize(lights.size());
    scratch.seen.resize(lights.size());
    parallelFor(lights.size(), threadsFor(lights.size() / 8), [&](size_t i) {
        scratch.seen[i] = 1;
        if (isUnlimited(lights[i])) return;
        scratch.all[i] = reachOf(lights[i]);
        scratch.seen[i] = view.mayMeet(scratch.all[i]) ? 1 : 0;
    });
    clusters.places.clear();
    const auto add = [&](bool unlimited) {
        for (size_t i = 0; i < lights.size(); ++i)
            if (scratch.seen[i] && (inLists || isUnlimited(lights[i]) == unlimited))
                clusters.places.push_back(static_cast<int32_t>(i));
    };
    if (!inLists) add(true);
    clusters.everywhere = static_cast<int>(clusters.places.size());
    add(false);
    clusters.lights.clear();
    scratch.reaches.clear();
    for (const int32_t place : clusters.places) {
        clusters.lights.push_back(lights[static_cast<size_t>(place)]);
        scratch.reaches.push_back(scratch.all[static_cast<size_t>(place)]);
    }
}

}  // namespace

ClusterBuilder::ClusterBuilder() : scratch_(std::make_unique<Scratch>()) {}
ClusterBuilder::~ClusterBuilder() = default;
ClusterBuilder::ClusterBuilder(ClusterBuilder&&) noexcept = default;
ClusterBuilder& ClusterBuilder::operator=(ClusterBuilder&&) noexcept = default;

bool ClusterBuilder::update(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                            const ClusterGrid& grid, int mostPerList)
{
    if (made_ && lights == lights_ && projection == projection_ && grid == grid_ &&
        mostPerList == mostPerList_)
        return false;
    for (const int side : {grid.columns, grid.rows, grid.slices})
        if (side < 0 || side > kMostOnASide)
            throw Error(ErrorKind::usage, "lists of lights",
                        Found("a grid with " + std::to_string(side) + " on a side")
                            .expected("0 to " + std::to_string(kMostOnASide)));
    made_ = false;  // until all of it is
    lights_ = lights;
    projection_ = projection;
    grid_ = grid;
    mostPerList_ = mostPerList;
    clusters_.grid = grid;
    clusters_.dropped = clusters_.longest = 0;
    setLights(clusters_, lights, projection, mostPerList > 0, *scratch_);
    const Interval range = reachedBy(clusters_, scratch_->reaches);
    setGrid(clusters_, scratch_->reaches, projection, range);
    setLists(clusters_, projection, range, *scratch_);
    if (mostPerList > 0) keepStrongest(clusters_, projection, range, mostPerList);
    for (size_t k = 1; k < clusters_.lists.size(); k += 2)
        clusters_.longest = std::max(clusters_.longest, clusters_.everywhere + clusters_.lists[k]);
    return made_ = true;
}

LightClusters lightClusters(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                            const ClusterGrid& grid, int mostPerList)
{
    ClusterBuilder builder;
    builder.update(lights, projection, grid, mostPerList);
    return builder.clusters();
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

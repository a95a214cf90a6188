#include "SampleFacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fbrdf::tool {
namespace {

// A pair as a point: wo and wi projected on the ground plane. Isotropic pairs are first turned so
// that wi has azimuth 0, and mirrored so that the azimuth of wo is positive.
using Point = std::array<float, 4>;

Point pointOf(const Vec3f& wo, const Vec3f& wi, bool isotropic)
{
    if (!isotropic) return {wo.x, wo.y, wi.x, wi.y};
    const float radius = std::hypot(wi.x, wi.y);
    const float c = radius > 0.0f ? wi.x / radius : 1.0f, s = radius > 0.0f ? wi.y / radius : 0.0f;
    return {wo.x * c + wo.y * s, std::abs(wo.y * c - wo.x * s), radius, 0.0f};
}

float squaredDistance(const Point& a, const Point& b)
{
    float sum = 0.0f;
    for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

// Points sorted into cells, so that the nearest point within the size of a cell lies in one of the
// 81 cells around.
class PointGrid {
public:
    PointGrid(const std::vector<Point>& points, float cellSize)
        : points_(points), cellSize_(cellSize)
    {
        entries_.reserve(points.size());
        for (uint32_t i = 0; i < points.size(); ++i)
            entries_.push_back({keyOf(cellOf(points[i])), i});
        std::sort(entries_.begin(), entries_.end());
    }

    /// Index of the nearest point within the size of a cell, or the number of points. Of a cell
    /// with more than kMostCompared points some are compared, evenly among them.
    size_t nearest(const Point& at) const
    {
        const Cell centre = cellOf(at);
        size_t best = points_.size();
        float bound = cellSize_ * cellSize_;
        for (int k = 0; k < 81; ++k) {
            const auto [begin, end] =
                entriesOf({centre[0] + k % 3 - 1, centre[1] + k / 3 % 3 - 1,
                           centre[2] + k / 9 % 3 - 1, centre[3] + k / 27 - 1});
            const size_t step = (end - begin) / kMostCompared + 1;
            for (size_t e = begin; e < end; e += step) {
                const float distance = squaredDistance(points_[entries_[e].second], at);
                if (distance >= bound) continue;
                bound = distance;
                best = entries_[e].second;
            }
        }
        return best;
    }

private:
    using Cell = std::array<int, 4>;
    static constexpr size_t kMostCompared = 256;

    Cell cellOf(const Point& p) const
    {
        Cell cell;
        for (size_t i = 0; i < 4; ++i)
            cell[i] = static_cast<int>(std::floor((p[i] + 2.0f) / cellSize_));
        return cell;
    }
    static uint64_t keyOf(const Cell& cell)  // coordinates are in (-2, 2): far below 2^16 cells
    {
        uint64_t key = 0;
        for (const int c : cell) key = key << 16 | static_cast<uint16_t>(c);
        return key;
    }
    std::pair<size_t, size_t> entriesOf(const Cell& cell) const
    {
        const uint64_t key = keyOf(cell);
        const auto begin = std::lower_bound(entries_.begin(), entries_.end(),
                                            std::pair<uint64_t, uint32_t>(key, 0));
        const auto end =
            std::upper_bound(begin, entries_.end(), key,
                             [](uint64_t k, const auto& entry) { return k < entry.first; });
        return {size_t(begin - entries_.begin()), size_t(end - entries_.begin())};
    }

    const std::vector<Point>& points_;
    float cellSize_;
    std::vector<std::pair<uint64_t, uint32_t>> entries_;  ///< key of the cell, index of the point
};

/// Grids from fine to coarse: the fine ones find near points where points are dense, as in a scan
/// of a few degrees, and the coarse one finds those of a sparse set.
class PointGrids {
public:
    explicit PointGrids(std::vector<Point> points) : points_(std::move(points))
    {
        for (const float divisor : {16.0f, 4.0f, 1.0f})
            grids_.emplace_back(points_, kSameDirection / divisor);
    }
    /// Index of a point within kSameDirection that is about the nearest, or the number of points.
    size_t nearest(const Point& at) const
    {
        for (const PointGrid& grid : grids_) {
            const size_t found = grid.nearest(at);
            if (found < points_.size()) return found;
        }
        return points_.size();
    }

private:
    std::vector<Point> points_;
    std::vector<PointGrid> grids_;
};

void addRatios(const Sample& a, const Sample& b, const Vec3f& floor, std::vector<double>& ratios)
{
    for (int c = 0; c < 3; ++c)
        if (a.f[c] > floor[c] && b.f[c] > floor[c])
            ratios.push_back(
                std::abs(std::log(static_cast<double>(a.f[c]) / static_cast<double>(b.f[c]))));
}

double median(std::vector<double>& values)
{
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

std::vector<Sample> thinnedSamples(const Source& source, uint64_t& available)
{
    const uint64_t rows = source.samples.size() + source.stream.rows;
    const uint64_t step = (rows + kMaxThinned - 1) / kMaxThinned;
    std::vector<Sample> kept;
    available = 0;
    forEachBlock(source, [&](const Sample* samples, size_t count) {
        for (size_t i = 0; i < count; ++i, ++available)
            if (available % step == 0) kept.push_back(samples[i]);
    });
    return kept;
}

SampleReciprocity sampleReciprocity(const std::vector<Sample>& samples, bool isotropic,
                                    const Vec3f& floor)
{
    std::vector<Point> points;
    for (const Sample& s : samples) points.push_back(pointOf(s.wo, s.wi, isotropic));
    const PointGrids grid(std::move(points));
    SampleReciprocity result;
    std::vector<double> ratios;
    const size_t step = samples.size() / kMostLookedUp + 1;
    for (size_t i = 0; i < samples.size(); i += step, ++result.lookedUp) {
        const size_t j = grid.nearest(pointOf(samples[i].wi, samples[i].wo, isotropic));
        if (j == samples.size() || j == i) continue;
        ++result.pairs;
        addRatios(samples[i], samples[j], floor, ratios);
    }
    if (ratios.empty()) result.pairs = 0;
    result.median = median(ratios);
    return result;
}

}  // namespace fbrdf::tool

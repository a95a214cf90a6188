#include "SampleFacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

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

// Points sorted into cells of the size of the largest distance, so that the nearest point lies in
// one of the 81 cells around.
class PointGrid {
public:
    explicit PointGrid(std::vector<Point> points) : points_(std::move(points))
    {
        for (size_t i = 0; i < points_.size(); ++i) cells_[keyOf(cellOf(points_[i]))].push_back(i);
    }

    /// Index of the nearest point within kSameDirection, or the number of points.
    size_t nearest(const Point& at) const
    {
        const Cell centre = cellOf(at);
        size_t best = points_.size();
        float bound = kSameDirection * kSameDirection;
        for (int k = 0; k < 81; ++k) {
            const Cell cell{centre[0] + k % 3 - 1, centre[1] + k / 3 % 3 - 1,
                            centre[2] + k / 9 % 3 - 1, centre[3] + k / 27 - 1};
            const auto found = cells_.find(keyOf(cell));
            if (found == cells_.end()) continue;
            for (const size_t i : found->second) {
                const float distance = squaredDistance(points_[i], at);
                if (distance < bound) {
                    bound = distance;
                    best = i;
                }
            }
        }
        return best;
    }

private:
    using Cell = std::array<int, 4>;

    static Cell cellOf(const Point& p)
    {
        Cell cell;
        for (size_t i = 0; i < 4; ++i)
            cell[i] = static_cast<int>(std::floor((p[i] + 2.0f) / kSameDirection));
        return cell;
    }
    static uint32_t keyOf(const Cell& cell)  // coordinates are in (-2, 2): 115 cells an axis
    {
        uint32_t key = 0;
        for (const int c : cell) key = key << 8 | static_cast<uint32_t>(c);
        return key;
    }

    std::vector<Point> points_;
    std::unordered_map<uint32_t, std::vector<size_t>> cells_;
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
    const PointGrid grid(std::move(points));
    SampleReciprocity result;
    std::vector<double> ratios;
    for (size_t i = 0; i < samples.size(); ++i) {
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

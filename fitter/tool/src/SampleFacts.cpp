#include "SampleFacts.h"

#include <fbrdf/base/Assert.h>

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

// The points of samples, sorted by cells of three sizes at once: those of one size, kSameDirection,
// are split into four along each coordinate, and these once more. A point's nearest neighbour
// within the size of a cell lies in one of the 81 cells around.
class PointIndex {
public:
    static constexpr int kFinest = 2;

    PointIndex(const std::vector<Sample>& samples, bool isotropic)
    {
        FBRDF_ASSERT(samples.size(), <=, size_t(1) << kIndexBits);
        keys_.reserve(samples.size());
        for (size_t i = 0; i < samples.size(); ++i) {
            const Point point = pointOf(samples[i].wo, samples[i].wi, isotropic);
            keys_.push_back(firstKey(cellOf(point, kFinest), kFinest) | i);
        }
        std::sort(keys_.begin(), keys_.end());
        points_.reserve(samples.size());
        for (const uint64_t key : keys_) {
            const Sample& sample = samples[indexOf(key)];
            points_.push_back(pointOf(sample.wo, sample.wi, isotropic));
        }
    }

    /// Index of the nearest sample within the size of a cell of the level, 0 the coarsest, or the
    /// number of samples. Of a cell with more than kMostCompared samples some are compared, evenly
    /// among them.
    size_t nearest(const Point& at, int level) const
    {
        const Cell centre = cellOf(at, level);
        const float size = sizeOf(level);
        size_t best = keys_.size();
        float bound = size * size;
        for (int k = 0; k < 81; ++k) {
            const uint64_t from = firstKey({centre[0] + k % 3 - 1, centre[1] + k / 3 % 3 - 1,
                                            centre[2] + k / 9 % 3 - 1, centre[3] + k / 27 - 1},
                                           level);
            const auto begin = std::lower_bound(keys_.begin(), keys_.end(), from);
            const auto end = std::lower_bound(begin, keys_.end(), from + keysIn(level));
            const size_t step = size_t(end - begin) / kMostCompared + 1;
            for (auto i = size_t(begin - keys_.begin()); i < size_t(end - keys_.begin());
                 i += step) {
                const float distance = squaredDistance(points_[i], at);
                if (distance >= bound) continue;
                bound = distance;
                best = indexOf(keys_[i]);
            }
        }
        return best;
    }

private:
    using Cell = std::array<uint32_t, 4>;
    static constexpr size_t kMostCompared = 256;
    // A key has the coordinates of the coarse cell, 7 bits each as they are below 3 / 0.035, then
    // 2 bits a coordinate for each finer level, then the index of the sample.
    static constexpr int kCoarseBits = 7, kSplitBits = 2, kIndexBits = 20;
    static_assert(4 * (kCoarseBits + kFinest * kSplitBits) + kIndexBits == 64);

    static float sizeOf(int level) { return kSameDirection / float(1 << kSplitBits * level); }
    static Cell cellOf(const Point& p, int level)
    {
        Cell cell;  // the cells around one with a coordinate of -1 have coordinates above 0
        for (size_t i = 0; i < 4; ++i)
            cell[i] = static_cast<uint32_t>((p[i] + 2.0f) / sizeOf(level));
        return cell;
    }
    static uint64_t keysIn(int level)
    {
        return uint64_t(1) << (4 * kSplitBits * (kFinest - level) + kIndexBits);
    }
    /// The least key in a cell of the level; those of its finer cells follow.
    static uint64_t firstKey(const Cell& cell, int level)
    {
        constexpr uint32_t kSplit = (1u << kSplitBits) - 1;
        uint64_t key = 0;
        for (const uint32_t c : cell) key = key << kCoarseBits | c >> kSplitBits * level;
        for (int finer = level - 1; finer >= 0; --finer)
            for (const uint32_t c : cell)
                key = key << kSplitBits | (c >> kSplitBits * finer & kSplit);
        return key * keysIn(level);
    }
    static size_t indexOf(uint64_t key)
    {
        return static_cast<size_t>(key & ((uint64_t(1) << kIndexBits) - 1));
    }

    std::vector<uint64_t> keys_;  ///< sorted
    std::vector<Point> points_;   ///< of each key
};

/// Indices of the samples that are exchanged with others, and of about the nearest of these.
struct ExchangedPair {
    size_t sample, other;
};

/// Looks in fine cells first, which find near samples where these are dense, as in a scan of a few
/// degrees, and in coarse ones last, for those of a sparse set.
std::vector<ExchangedPair> exchangedPairs(const std::vector<Sample>& samples, bool isotropic)
{
    std::vector<ExchangedPair> pairs;
    const PointIndex index(samples, isotropic);
    const size_t step = samples.size() / kMostLookedUp + 1;
    for (size_t i = 0; i < samples.size(); i += step) {
        const Point exchanged = pointOf(samples[i].wi, samples[i].wo, isotropic);
        size_t other = samples.size();
        for (int level = PointIndex::kFinest; level >= 0 && other == samples.size(); --level)
            other = index.nearest(exchanged, level);
        pairs.push_back({i, other});
    }
    return pairs;
}

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

SampleSurvey surveyOf(const Source& source)
{
    SampleSurvey survey;
    survey.report = source.report;
    const uint64_t rows = source.samples.size() + source.stream.rows;
    const uint64_t step = (rows + kMaxSurveyed - 1) / kMaxSurveyed;
    survey.thinned.reserve(static_cast<size_t>(std::min(rows, kMaxSurveyed)));
    const auto add = [&](const Sample& s) {
        if (survey.usable == 0) survey.least = survey.most = s.f;
        survey.least = glm::min(survey.least, s.f);
        survey.most = glm::max(survey.most, s.f);
        if (survey.usable++ % step == 0) survey.thinned.push_back(s);
    };
    for (const Sample& s : source.samples) add(s);
    std::vector<Sample> block;
    for (uint64_t first = 0; first < source.stream.rows; first += kSampleBlock) {
        block.clear();
        const uint64_t count = std::min<uint64_t>(kSampleBlock, source.stream.rows - first);
        source.stream.read(first, static_cast<size_t>(count), block, survey.report);
        for (const Sample& s : block) add(s);
    }
    return survey;
}

SampleReciprocity sampleReciprocity(const std::vector<Sample>& samples, bool isotropic,
                                    const Vec3f& floor)
{
    SampleReciprocity result;
    std::vector<double> ratios;
    for (const ExchangedPair& pair : exchangedPairs(samples, isotropic)) {
        ++result.lookedUp;
        if (pair.other == samples.size() || pair.other == pair.sample) continue;
        ++result.pairs;
        addRatios(samples[pair.sample], samples[pair.other], floor, ratios);
    }
    if (ratios.empty()) result.pairs = 0;
    result.median = median(ratios);
    return result;
}

}  // namespace fbrdf::tool

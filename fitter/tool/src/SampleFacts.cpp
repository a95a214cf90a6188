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

// The points of samples sorted into cells, so that the nearest point within the size of a cell lies
// in one of the 81 cells around.
class PointGrid {
public:
    PointGrid(const std::vector<Sample>& samples, bool isotropic, float cellSize)
        : samples_(samples), isotropic_(isotropic), cellSize_(cellSize)
    {
        entries_.reserve(samples.size());
        for (uint32_t i = 0; i < samples.size(); ++i)
            entries_.push_back({keyOf(cellOf(point(i))), i});
        std::sort(entries_.begin(), entries_.end());
    }

    /// Index of the nearest sample within the size of a cell, or the number of samples. Of a cell
    /// with more than kMostCompared samples some are compared, evenly among them.
    size_t nearest(const Point& at) const
    {
        const Cell centre = cellOf(at);
        size_t best = samples_.size();
        float bound = cellSize_ * cellSize_;
        for (int k = 0; k < 81; ++k) {
            const auto [begin, end] =
                entriesOf({centre[0] + k % 3 - 1, centre[1] + k / 3 % 3 - 1,
                           centre[2] + k / 9 % 3 - 1, centre[3] + k / 27 - 1});
            const size_t step = (end - begin) / kMostCompared + 1;
            for (size_t e = begin; e < end; e += step) {
                const float distance = squaredDistance(point(entries_[e].second), at);
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

    Point point(size_t index) const
    {
        return pointOf(samples_[index].wo, samples_[index].wi, isotropic_);
    }
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

    const std::vector<Sample>& samples_;
    bool isotropic_;
    float cellSize_;
    std::vector<std::pair<uint64_t, uint32_t>> entries_;  ///< key of the cell, index of the sample
};

/// Indices of the samples that are exchanged with others, and of about the nearest of these.
struct ExchangedPair {
    size_t sample, other;
};

/// Looks in grids from fine to coarse, of which there is one at a time: the fine ones find near
/// samples where these are dense, as in a scan of a few degrees, the coarse one those of a sparse
/// set.
std::vector<ExchangedPair> exchangedPairs(const std::vector<Sample>& samples, bool isotropic)
{
    std::vector<ExchangedPair> pairs;
    const size_t step = samples.size() / kMostLookedUp + 1;
    for (size_t i = 0; i < samples.size(); i += step) pairs.push_back({i, samples.size()});
    for (const float divisor : {16.0f, 4.0f, 1.0f}) {
        const PointGrid grid(samples, isotropic, kSameDirection / divisor);
        for (ExchangedPair& pair : pairs)
            if (pair.other == samples.size())
                pair.other = grid.nearest(
                    pointOf(samples[pair.sample].wi, samples[pair.sample].wo, isotropic));
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

#include "data/DataStatistics.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Parallel.h>
#include <fbrdf/fit/NoiseFloor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

// With fewer than one for each held-out fold there would be no errors to state, and a single sample
// fits every form.

// A function that reaches 0 is cut off there, and values just above 0 carry no more information
// than the zeros: those below this share of the median count as equal. Without zeros every value
// counts.
constexpr float kCutOff = 0.004f;

Vec3f floorOfFunction(const std::vector<Sample>& samples)
{
    Vec3f floor(0.0f);
    for (int c = 0; c < 3; ++c) {
        std::vector<float> positive;
        for (const Sample& s : samples)
            if (s.f[c] > 0.0f) positive.push_back(s.f[c]);
        if (positive.size() < samples.size()) floor[c] = kCutOff * quantile(positive, 0.5);
    }
    return floor;
}

bool isGrey(const Sample& s)
{
    return s.f.x == s.f.y && s.f.y == s.f.z;
}

bool weighsAsGiven(const Sample& s, const DataStatistics& statistics)
{
    for (int c = 0; c < 3; ++c)
        if (observe(s.f[c], s.wi.z, statistics, c, s.weight).weight != s.weight) return false;
    return true;
}

// Counts the blocks of this process with a sample that contradicts sameWeights, and those with one
// that contradicts grey.
std::vector<double> contradictions(const Dataset& dataset, const DataStatistics& statistics,
                                   const StatisticsOptions& options)
{
    const size_t first = dataset.blocks() * options.ranks.rank / options.ranks.count,
                 last = dataset.blocks() * (options.ranks.rank + 1) / options.ranks.count;
    std::vector<char> weights(last - first, 0), colours(last - first, 0);
    parallelTasks(last - first, options.threads, [&](size_t b) {
        DatasetScratch scratch;
        const DatasetBlock block = dataset.block(first + b, scratch);
        const Sample* end = block.samples + block.count;
        weights[b] = !std::all_of(block.samples, end,
                                  [&](const Sample& s) { return weighsAsGiven(s, statistics); });
        colours[b] = !std::all_of(block.samples, end, isGrey);
    });
    const auto blocks = [](const std::vector<char>& marks) {
        return static_cast<double>(std::count(marks.begin(), marks.end(), 1));
    };
    return {blocks(weights), blocks(colours)};
}

}  // namespace

float quantile(std::vector<float>& values, double fraction)
{
    FBRDF_ASSERT(fraction, >=, 0.0);
    FBRDF_ASSERT(fraction, <=, 1.0);
    if (values.empty()) return 0.0f;
    const auto rank = std::min(values.size() - 1,
                               static_cast<size_t>(fraction * static_cast<double>(values.size())));
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

Observed observe(float f, float cosine, const DataStatistics& statistics, int channel,
                 float sampleWeight)
{
    constexpr float kLeast = std::numeric_limits<float>::min();
    const float floor = floorAt(statistics, channel, cosine);
    if (statistics.exact && floor > 0.0f)
        return {std::max({f, floor, kLeast}), sampleWeight, false};
    if (f > 0.0f && f > 0.5f * floor) {
        const float variance = (floor / f) * (floor / f);
        return {std::max(f, kLeast), sampleWeight / (1.0f + variance), false};
    }
    // Without an estimate of the floor a zero does not bound f, and takes no part.
    if (floor > 0.0f) return {std::max(floor, kLeast), 0.5f * sampleWeight, true};
    return {1.0f, 0.0f, true};
}

DataStatistics statisticsOf(const std::vector<Sample>& samples, bool exact,
                            const std::string& source, size_t fewest)
{
    DataStatistics statistics;
    statistics.exact = exact;
    if (exact) {
        statistics.floor = floorOfFunction(samples);
    } else {
        const NoiseModel noise = estimateNoise(samples);
        statistics.floor = noise.sigma;
        statistics.floorOverCosine = noise.overCosine;
        statistics.unclipped = noise.unclipped;
    }
    statistics.sameWeights = true;
    statistics.grey = exact && std::all_of(samples.begin(), samples.end(), isGrey);
    std::array<std::vector<float>, 3> logs;
    for (const Sample& s : samples) {
        bool usable = false;
        for (int c = 0; c < 3; ++c) {
            const Observed o = observe(s.f[c], s.wi.z, statistics, c, s.weight);
            if (o.censored) {
                statistics.sameWeights = false;
                continue;
            }
            logs[static_cast<size_t>(c)].push_back(std::log2(o.value));
            usable = usable || o.weight > 0.0f;
        }
        statistics.usable += usable ? 1 : 0;
    }
    for (int c = 0; c < 3; ++c) {
        if (!exact && statistics.floor[c] > 0.0f) statistics.sameWeights = false;
        statistics.level[c] = quantile(logs[static_cast<size_t>(c)], 0.5);
        statistics.low[c] = quantile(logs[static_cast<size_t>(c)], 0.1);
    }
    if (statistics.usable < fewest)
        throw Error(ErrorKind::fit, source,
                    Found(std::to_string(samples.size()) + ", of which " +
                          std::to_string(statistics.usable) + " have a value above the noise floor")
                        .expected("at least " + std::to_string(fewest) + " samples that have"));
    return statistics;
}

DataStatistics statisticsOf(const Dataset& dataset, const StatisticsOptions& options,
                            const std::string& source)
{
    constexpr size_t kSamples = 65536;
    DataStatistics statistics = statisticsOf(
        someSamples(dataset, FoldChoice::all(), kSamples, options.seed, options.threads),
        dataset.exact, source, options.fewest);
    if (!statistics.sameWeights && !statistics.grey) return statistics;
    std::vector<double> found = contradictions(dataset, statistics, options);
    options.ranks.sum(found);
    statistics.sameWeights = statistics.sameWeights && found[0] == 0.0;
    statistics.grey = statistics.grey && found[1] == 0.0;
    return statistics;
}

}  // namespace fbrdf

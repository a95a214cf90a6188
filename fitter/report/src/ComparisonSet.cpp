#include "ComparisonSet.h"

#include <fbrdf/metrics/SampleSets.h>

#include <algorithm>

namespace fbrdf {
namespace {

constexpr size_t kUniformPairs = 65536;

std::vector<Sample> thinned(const std::vector<Sample>& samples, size_t most)
{
    if (samples.size() <= most) return samples;
    std::vector<Sample> chosen;
    for (size_t i = 0; i < most; ++i) chosen.push_back(samples[i * samples.size() / most]);
    return chosen;
}

// Reads short runs of rows at even distances, because a file of 50 million rows need not be read
// for 200,000 of them.
std::vector<Sample> thinned(const SampleStream& stream, size_t most)
{
    constexpr size_t kRun = 16;
    std::vector<Sample> chosen;
    SampleReport ignored;
    if (stream.rows <= most) {
        stream.read(0, static_cast<size_t>(stream.rows), chosen, ignored);
        return chosen;
    }
    const size_t runs = most / kRun;
    for (size_t i = 0; i < runs; ++i) {
        const uint64_t first = i * (stream.rows - kRun) / std::max<size_t>(1, runs - 1);
        stream.read(first, kRun, chosen, ignored);
    }
    return chosen;
}

}  // namespace

ComparisonSet comparisonSet(const Source& source, const Material& material, size_t most)
{
    ComparisonSet set;
    set.measured = hasSamples(source);
    if (!source.samples.empty()) {
        set.samples = thinned(source.samples, most);
        set.rows = source.samples.size();
    } else if (source.stream) {
        set.samples = thinned(source.stream, most);
        set.rows = source.stream.rows;
    } else if (source.evaluate) {
        set.samples = samplesAt(source, uniformPairs(std::min(kUniformPairs, most)), 0);
        set.rows = set.samples.size();
    }
    set.fitted = evaluateAt(material, set.samples, 0);
    return set;
}

}  // namespace fbrdf

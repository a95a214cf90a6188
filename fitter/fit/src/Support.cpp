#include "Support.h"

#include "Parallel.h"
#include "Rows.h"

#include <algorithm>

namespace fbrdf {
namespace {

constexpr size_t kChunk = 16;  // blocks between two looks at whether all is supported

bool isUsable(const Sample& sample, const DataTraits& traits)
{
    for (int c = 0; c < 3; ++c) {
        const Observed o = observe(sample.f[c], traits.floor[c], sample.weight);
        if (!o.censored && o.weight > 0.0f) return true;
    }
    return false;
}

void addBlock(const Feed& feed, size_t block, const RowMaker& rows, const DataTraits& traits,
              std::vector<float>& sums)
{
    std::vector<Sample> scratch;
    std::vector<int> unknown(static_cast<size_t>(rows.width()));
    std::vector<float> weight(unknown.size());
    const FeedBlock samples = feed.block(block, scratch);
    for (size_t i = 0; i < samples.count; ++i) {
        if (!isUsable(samples.samples[i], traits)) continue;
        rows.make(samples.samples[i], unknown.data(), weight.data());
        for (size_t k = 0; k < unknown.size(); ++k)
            sums[static_cast<size_t>(unknown[k])] += weight[k];
    }
}

}  // namespace

void markUnsupported(Material& material, const Feed& feed, const DataTraits& traits, int threads)
{
    const Layout layout(material.form);
    const RowMaker rows(material.form, layout);
    std::vector<float> sums(static_cast<size_t>(layout.unknowns()), 0.0f);
    const auto isSupported = [](float sum) { return sum > kSupport; };
    std::vector<bool> wanted(sums.size(), false);
    for (size_t t = 0; t < material.tables.size(); ++t)
        for (int i = 0; i < texelCount(material.tables[t].domain); ++i)
            if (isReachable(material.tables[t].domain, i))
                wanted[static_cast<size_t>(layout.unknownOf(t, i))] = true;
    for (size_t u = 0; u < sums.size(); ++u)
        if (!wanted[u]) sums[u] = 1.0f;  // nothing reads it
    for (size_t first = 0; first < feed.blocks(); first += kChunk) {
        // Parts of their own, added in order: the same sums whatever the number of threads.
        const size_t count = std::min(kChunk, feed.blocks() - first);
        std::vector<std::vector<float>> parts(count, std::vector<float>(sums.size(), 0.0f));
        parallelTasks(count, threads,
                      [&](size_t b) { addBlock(feed, first + b, rows, traits, parts[b]); });
        for (const auto& part : parts)
            for (size_t u = 0; u < sums.size(); ++u) sums[u] += part[u];
        if (std::all_of(sums.begin(), sums.end(), isSupported)) break;
    }
    for (size_t t = 0; t < material.tables.size(); ++t) {
        Table& table = material.tables[t];
        table.unsupported.assign(static_cast<size_t>(texelCount(table.domain)), false);
        for (size_t i = 0; i < table.unsupported.size(); ++i)
            table.unsupported[i] =
                !isSupported(sums[static_cast<size_t>(layout.unknownOf(t, static_cast<int>(i)))]);
    }
}

}  // namespace fbrdf

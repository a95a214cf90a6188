#include "TexelWeights.h"

#include <fbrdf/base/Assert.h>

namespace fbrdf {
namespace {

bool isUsable(const RowValues& values, size_t i)
{
    for (int c = 0; c < 3; ++c)
        if (values.weight[i][c] > 0.0f && (values.censored[i] >> c & 1) == 0) return true;
    return false;
}

std::vector<double> countedWeights(const LeastSquares& problem)
{
    const auto width = static_cast<size_t>(problem.maker().width());
    std::vector<std::vector<double>> parts(kParts, std::vector<double>(problem.unknowns(), 0.0));
    problem.forEachBlock([&](size_t part, size_t block, RowStore::Scratch& scratch) {
        const RowStore::Block rows = problem.store().block(block, scratch);
        for (size_t i = 0; i < rows.geometry.count; ++i) {
            if (!isUsable(rows.values, i)) continue;
            for (size_t k = i * width; k < (i + 1) * width; ++k)
                parts[part][static_cast<size_t>(rows.geometry.unknown[k])] +=
                    static_cast<double>(rows.geometry.weight[k]);
        }
    });
    std::vector<double> sum(problem.unknowns(), 0.0);
    for (const auto& part : parts)
        for (size_t u = 0; u < sum.size(); ++u) sum[u] += part[u];
    problem.options().ranks.sum(sum);
    return sum;
}

}  // namespace

std::vector<double> texelWeights(const LeastSquares& problem)
{
    constexpr size_t kStreamRows = 262144;
    if (!problem.isInMemory()) return texelWeights(problem.thinned(kStreamRows, kNoFold));
    // With samples of equal weight the sums depend on the pairs of directions alone: fits on the
    // same grid share them.
    if (problem.cacheKey().empty() || !problem.store().sameWeights())
        return countedWeights(problem);
    FitCache& cache = *problem.options().cache;
    auto known = cache.texelWeights(problem.cacheKey());
    if (!known) {
        known = std::make_shared<const std::vector<double>>(countedWeights(problem));
        cache.keepTexelWeights(problem.cacheKey(), known);
    }
    return *known;
}

void markUnsupported(Material& material, const Layout& layout, const std::vector<double>& weights)
{
    FBRDF_ASSERT(weights.size(), ==, static_cast<size_t>(layout.unknowns()));
    for (size_t t = 0; t < material.tables.size(); ++t) {
        Table& table = material.tables[t];
        const int texels = texelCount(table.domain);
        table.unsupported.assign(static_cast<size_t>(texels), false);
        for (int i = 0; i < texels; ++i)
            table.unsupported[static_cast<size_t>(i)] =
                isReachable(table.domain, i) &&
                !(weights[static_cast<size_t>(layout.unknownOf(t, i))] > kLeastTexelWeight);
    }
}

}  // namespace fbrdf

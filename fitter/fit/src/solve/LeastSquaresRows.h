// LeastSquaresRows.h - what LeastSquares.cpp and LeastSquaresStep.cpp share: one pass over rows.
#pragma once
#include <fbrdf/base/Parallel.h>
#include "solve/LeastSquares.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf {

// Sums are made in this many parts whatever the number of threads, and added in order: the same
// bits everywhere.
constexpr size_t kParts = 4;

/// A state as rows read it: floats, a lane a channel.
struct LeastSquares::Texels {
    std::vector<float> values;  ///< unknowns x kLanes; none where the levels say all
    std::vector<float> levels;  ///< terms x kLanes; 0 without a shared shape

    Texels(const LeastSquares& problem, const State& x);

private:
    bool takeFlat(const LeastSquares& problem, const State& x);
};

/// What a state says of rows, a lane a channel.
struct LeastSquares::Predicted {
    std::vector<float> logG;   ///< rows x kLanes: log2 g
    std::vector<float> share;  ///< rows x terms x kLanes: what each term contributes to g
};

/// What a visitor of rows sees of one sample.
struct LeastSquares::Row {
    Vec3f residual;      ///< in the metric's own terms
    Vec3f sampleWeight;  ///< all in all; 0: the channel says nothing
    Vec3f noiseWeight;   ///< without metric and robustness
};

/// Channels that one pass over the rows serves: [first, first + channels), a lane each, with a
/// matrix a lane (kLanes), one for all (1) or none (0: it is known).
struct LeastSquares::Pass {
    size_t first, channels, matrices;
};

/// The rows of one block as kernels take them: one a sample, with a shared shape one a channel.
/// Storage that is used again from block to block.
struct LeastSquares::NormalRows {
    std::vector<int> unknown;   ///< of a shared shape: with levels
    std::vector<float> weight;  ///< likewise
    std::vector<int> termEnd;
    std::vector<float> share, sampleWeight, residual;
    std::vector<unsigned char> group;
    KernelRows rows{};
    int entryLanes = 1;
};

/// Which sums a sample adds to, by its fold.
using FoldGroups = std::array<unsigned char, kFolds>;
/// 0: in no fold of `folds`; then those of each fold; kNoGroup: excluded.
FoldGroups groupsOf(const std::vector<int>& folds, int excluded);

/// What rows of normal equations are made of besides the data.
struct LeastSquares::RowOptions {
    const StepOptions& options;
    Vec3f scale;  ///< of robust weights
    Texels texels;
    Pass pass;
    FoldGroups groups;
};

// phi(f), phi(g) and d phi / d log2 g of the metrics; c is cos theta_i.
struct Response {
    float residual, weight;
};
Response responseInMetric(Metric metric, float c, float logF, float logG);  ///< not of log
inline Response responseOf(Metric metric, float c, float logF, float logG)
{
    if (metric == Metric::log) return {logF - logG, 1.0f};
    return responseInMetric(metric, c, logF, logG);
}

// Beaton and Tukey 1974: (1 - (r / (c s))^2)^2 within c s, 0 beyond. 95 % efficiency for Gaussian
// noise.
constexpr float kTukey = 4.685f;

inline float biweight(float residual, float scale)
{
    const float ratio = residual / (kTukey * scale);
    const float inside = std::max(0.0f, 1.0f - ratio * ratio);
    return inside * inside;
}

// The loss that the biweight belongs to, as a share of the squared residual: (1 - (1 - u^2)^3) /
// (3 u^2), u = r / (c s) and at most 1 in the numerator.
inline float biweightLoss(float residual, float scale)
{
    const float ratio = residual / (kTukey * scale), squared = std::max(ratio * ratio, 1e-6f);
    const float outside = std::max(0.0f, 1.0f - squared);
    return (1.0f - outside * outside * outside) / (3.0f * squared);
}

inline double LeastSquares::bounded(double octaves) const
{
    constexpr double kMost = 4.0;
    return form_.terms.size() > 1 ? std::clamp(octaves, -kMost, kMost) : octaves;
}

template <class Visit>
void LeastSquares::forEachBlock(const Visit& visit) const
{
    const RankSum& ranks = options_.ranks;
    const size_t first = store_->blocks() * ranks.rank / ranks.count,
                 last = store_->blocks() * (ranks.rank + 1) / ranks.count;
    parallelTasks(kParts, threads_, [&](size_t part) {
        RowStore::Scratch scratch;
        const size_t blocks = last - first;
        for (size_t b = blocks * part / kParts; b < blocks * (part + 1) / kParts; ++b)
            visit(part, first + b, scratch);
    });
}

// The mean of logarithms of noisy values is not the logarithm of their mean, values near the floor
// have no logarithm, and a weight taken from f favours what noise made large. f / g - 1 of all
// values, weighted by what noise makes of it at g, has a mean of 0 where g is right (the estimating
// equation of a quasi-likelihood; Wedderburn 1974). Returns the weight.
inline float LeastSquares::unbiasedAt(const RowStore::Block& rows, size_t i, int c, float logG,
                                      float& residual) const
{
    constexpr float kLog2E = 1.442695f;
    const float g = std::exp2(logG);
    const float noise = floorAt(traits_, c, rows.geometry.cosine[i]) / g;
    residual = kLog2E * (rows.values.value[i][c] / g - 1.0f);
    return rows.values.sampleWeight[i] / (1.0f + noise * noise);
}

/// logG: kLanes, as Predicted has them.
inline LeastSquares::Row LeastSquares::rowAt(const RowStore::Block& rows, size_t i,
                                             const float* logG, const StepOptions& options,
                                             const Vec3f& scale) const
{
    Row row{Vec3f(0.0f), Vec3f(0.0f), rows.values.weight[i]};
    for (int c = 0; c < 3; ++c) {
        if (options.unbiased && traits_.floor[c] > 0.0f) {
            row.noiseWeight[c] = unbiasedAt(rows, i, c, logG[c], row.residual[c]);
            row.sampleWeight[c] = row.noiseWeight[c];
            if (options.robust)
                row.sampleWeight[c] *=
                    biweight(row.residual[c] * std::sqrt(row.noiseWeight[c]), scale[c]);
            continue;
        }
        if (row.noiseWeight[c] == 0.0f) continue;
        const Response response = responseOf(options.metric, rows.geometry.cosine[i],
                                             rows.values.logValue[i][c], logG[c]);
        row.residual[c] = response.residual;
        const bool censored = (rows.values.censored[i] >> c & 1) != 0;
        if (censored && response.residual >= 0.0f) continue;
        row.sampleWeight[c] = row.noiseWeight[c] * response.weight;
        if (options.robust)
            row.sampleWeight[c] *=
                biweight(row.residual[c] * std::sqrt(row.noiseWeight[c]), scale[c]);
    }
    return row;
}

template <class Visit>
void LeastSquares::forEachRow(size_t block, RowStore::Scratch& scratch, const Texels& texels,
                              const StepOptions& options, const Vec3f& scale,
                              const Visit& visit) const
{
    const RowStore::Block rows = store_->block(block, scratch);
    Predicted predicted;
    predict(rows.geometry, 0, rows.geometry.count, texels, predicted);
    const bool everyFold = options.excludedFold == kNoFold;
    for (size_t i = 0; i < rows.geometry.count; ++i) {
        const int fold = foldOf(rows.geometry.number(i), seed_);
        if (everyFold || fold != options.excludedFold)
            visit(rowAt(rows, i, &predicted.logG[i * kLanes], options, scale), fold);
    }
}

}  // namespace fbrdf

// RowWeights.h - how much the residual of a sample counts: noise, metric and robustness.
//
// Noise: a value f weighs f^2 / (f^2 + floor^2). A value below the noise floor is censored: it is
// known to lie below, and pulls only a prediction that lies above.
// Metric: another phi than log changes weight and residual of the same row, to w phi'^2 and
// (phi(f) - phi(g)) / phi', with derivatives by log2 g.
// Robustness: Beaton and Tukey 1974, "The Fitting of Power Series, Meaning Polynomials": the
// biweight of a residual, in units of the scale of all residuals.
#pragma once
#include "solve/Prediction.h"
#include "solve/StepOptions.h"

#include <algorithm>
#include <cmath>

namespace fbrdf {

/// One sample as a least-squares row sees it, a channel at a time in Vec3f.
struct WeightedRow {
    Vec3f residual;      ///< in the metric's own terms
    Vec3f sampleWeight;  ///< all weights multiplied; 0: the channel takes no part
    Vec3f noiseWeight;   ///< without metric and robustness
};

/// Rows or weights of a step differ from state to state: the problem is not linear.
bool dependsOnState(const LeastSquares& problem, const StepOptions& options);

/// The scale of the residuals at a state: the median of their magnitudes, in units of the expected
/// noise, as the standard deviation of a normal distribution. 1 where `options` are not robust.
Vec3f residualScale(const LeastSquares& problem, const State& x, const StepOptions& options);

/// Weighted mean of squared residuals: what a damped step must lower. With robust options each is
/// bounded as the biweight is, with the scale given.
double cost(const LeastSquares& problem, const State& x, const StepOptions& options,
            const Vec3f& scale);

/// Weighs the rows of one problem.
class RowWeights {
public:
    /// `problem` must outlive the object; `scale`: see residualScale.
    RowWeights(const LeastSquares& problem, const StepOptions& options, const Vec3f& scale)
        : statistics_(problem.statistics()), options_(options), scale_(scale)
    {
    }
    /// Sample i of a block for which log2 g is `logG`, kLanes numbers.
    WeightedRow operator()(const RowStore::Block& rows, size_t i, const float* logG) const;

private:
    void weighValue(const RowStore::Block& rows, size_t i, int c, float logG,
                    WeightedRow& row) const;
    void weighLogarithm(const RowStore::Block& rows, size_t i, int c, float logG,
                        WeightedRow& row) const;
    float robustWeight(const WeightedRow& row, int c) const;

    const DataStatistics& statistics_;
    StepOptions options_;
    Vec3f scale_;
};

/// What a row gives to the equations in a metric phi: (phi(f) - phi(g)) / phi' and phi'^2.
struct Response {
    float residual, weight;
};
/// The response in a metric other than log. f and g are multiplied by `cosine`, that of theta_i.
Response responseInMetric(Metric metric, float cosine, float logF, float logG);
inline Response responseOf(Metric metric, float cosine, float logF, float logG)
{
    if (metric == Metric::log) return {logF - logG, 1.0f};
    return responseInMetric(metric, cosine, logF, logG);
}

/// The c of the biweight (1 - (r / (c s))^2)^2, which is 0 beyond c s: 95 % efficiency for normal
/// noise (Beaton and Tukey 1974).
constexpr float kTukey = 4.685f;

inline float biweight(float residual, float scale)
{
    const float ratio = residual / (kTukey * scale);
    const float inside = std::max(0.0f, 1.0f - ratio * ratio);
    return inside * inside;
}

/// The loss whose derivative gives the biweight, as a share of the squared residual:
/// (1 - (1 - u^2)^3) / (3 u^2), u = r / (c s), where 1 - u^2 is at least 0.
inline float biweightLoss(float residual, float scale)
{
    constexpr float kTiny = 1e-6f;  // where the share is 1 to the last digit of a float
    const float ratio = residual / (kTukey * scale), squared = std::max(ratio * ratio, kTiny);
    const float outside = std::max(0.0f, 1.0f - squared);
    return (1.0f - outside * outside * outside) / (3.0f * squared);
}

inline float RowWeights::robustWeight(const WeightedRow& row, int c) const
{
    return biweight(row.residual[c] * std::sqrt(row.noiseWeight[c]), scale_[c]);
}

// The mean of logarithms of noisy values is not the logarithm of their mean, values near the floor
// have no logarithm, and a weight taken from f favours what noise made large. f / g - 1 of all
// values, weighted by what noise makes of it at g, has a mean of 0 where g is right (the estimating
// equation of a quasi-likelihood; Wedderburn 1974).
inline void RowWeights::weighValue(const RowStore::Block& rows, size_t i, int c, float logG,
                                   WeightedRow& row) const
{
    constexpr float kLog2E = 1.442695f;
    const float g = std::exp2(logG);
    const float noise = floorAt(statistics_, c, rows.geometry.cosine[i]) / g;
    row.residual[c] = kLog2E * (rows.values.value[i][c] / g - 1.0f);
    row.noiseWeight[c] = rows.values.sampleWeight[i] / (1.0f + noise * noise);
    row.sampleWeight[c] = row.noiseWeight[c];
    if (options_.robust) row.sampleWeight[c] *= robustWeight(row, c);
}

inline void RowWeights::weighLogarithm(const RowStore::Block& rows, size_t i, int c, float logG,
                                       WeightedRow& row) const
{
    if (row.noiseWeight[c] == 0.0f) return;
    const Response response =
        responseOf(options_.metric, rows.geometry.cosine[i], rows.values.logValue[i][c], logG);
    row.residual[c] = response.residual;
    const bool censored = (rows.values.censored[i] >> c & 1) != 0;
    if (censored && response.residual >= 0.0f) return;
    row.sampleWeight[c] = row.noiseWeight[c] * response.weight;
    if (options_.robust) row.sampleWeight[c] *= robustWeight(row, c);
}

inline WeightedRow RowWeights::operator()(const RowStore::Block& rows, size_t i,
                                          const float* logG) const
{
    WeightedRow row{Vec3f(0.0f), Vec3f(0.0f), rows.values.weight[i]};
    for (int c = 0; c < 3; ++c) {
        if (options_.unbiased && statistics_.floor[c] > 0.0f)
            weighValue(rows, i, c, logG[c], row);
        else
            weighLogarithm(rows, i, c, logG[c], row);
    }
    return row;
}

}  // namespace fbrdf

#include "solve/RowWeights.h"

#include <fbrdf/base/Assert.h>

#include <array>

namespace fbrdf {
namespace {

constexpr float kMadToSigma = 1.4826f;  // of a normal distribution: 1 / 0.6745
// log2; smaller residuals come from what the form cannot represent, and are no outliers.
constexpr float kSmallestScale = 0.12f;
constexpr size_t kScaleBlocks = 24;  // blocks that the scale of the residuals is taken from
constexpr float kLn2 = 0.69314718056f;

/// Calls visit(row) for the samples of a block that take part.
template <class Visit>
void forEachRow(const LeastSquares& problem, size_t block, RowStore::Scratch& scratch,
                const Texels& texels, const StepOptions& options, const Visit& visit)
{
    const RowWeights weigh(problem, options, Vec3f(1.0f));
    const RowStore::Block rows = problem.store().block(block, scratch);
    Prediction predicted;
    predict(problem, rows.geometry, 0, rows.geometry.count, texels, predicted);
    for (size_t i = 0; i < rows.geometry.count; ++i)
        if (options.excludedFold == kNoFold ||
            foldOf(rows.geometry.number(i), problem.seed()) != options.excludedFold)
            visit(weigh(rows, i, &predicted.logG[i * kLanes]));
}

/// |residual| in units of the expected noise, of each channel.
using Magnitudes = std::array<std::vector<float>, 3>;

void appendMagnitudes(const WeightedRow& row, Magnitudes& magnitudes)
{
    for (int c = 0; c < 3; ++c)
        if (row.sampleWeight[c] > 0.0f)
            magnitudes[static_cast<size_t>(c)].push_back(std::abs(row.residual[c]) *
                                                         std::sqrt(row.noiseWeight[c]));
}

StepOptions withoutRobustness(StepOptions options)
{
    options.robust = false;
    return options;
}

}  // namespace

bool dependsOnState(const LeastSquares& problem, const StepOptions& options)
{
    return !problem.store().sameWeights() || options.robust || problem.terms() > 1 ||
           options.metric != Metric::log;
}

Response responseInMetric(Metric metric, float cosine, float logF, float logG)
{
    constexpr float kLeastSlope = 1e-12f;  // f cos theta_i of nothing: no residual is infinite
    const float f = cosine * std::exp2(logF), g = cosine * std::exp2(logG);
    const bool cube = metric == Metric::cubeRoot;
    const float phiF = cube ? std::cbrt(f) : std::log1p(f);
    const float phiG = cube ? std::cbrt(g) : std::log1p(g);
    const float slope = std::max(cube ? phiG * kLn2 / 3.0f : kLn2 * g / (1.0f + g), kLeastSlope);
    return {(phiF - phiG) / slope, slope * slope};
}

Vec3f residualScale(const LeastSquares& problem, const State& x, const StepOptions& options)
{
    if (!options.robust) return Vec3f(1.0f);
    const StepOptions plain = withoutRobustness(options);
    const Texels texels(problem, x);
    const size_t blocks = problem.store().blocks(),
                 stride = std::max<size_t>(1, blocks / kScaleBlocks);
    std::vector<Magnitudes> magnitudes((blocks + stride - 1) / stride);
    parallelTasks(magnitudes.size(), problem.threads(), [&](size_t b) {
        RowStore::Scratch scratch;
        forEachRow(problem, b * stride, scratch, texels, plain,
                   [&](const WeightedRow& row) { appendMagnitudes(row, magnitudes[b]); });
    });
    Vec3f scale;
    for (size_t c = 0; c < 3; ++c) {
        std::vector<float> all;
        for (const Magnitudes& part : magnitudes)
            all.insert(all.end(), part[c].begin(), part[c].end());
        scale[static_cast<int>(c)] = std::max(quantile(all, 0.5) * kMadToSigma, kSmallestScale);
    }
    return scale;
}

double cost(const LeastSquares& problem, const State& x, const StepOptions& options,
            const Vec3f& scale)
{
    const StepOptions plain = withoutRobustness(options);
    const Texels texels(problem, x);
    std::vector<double> sums(2 * kParts, 0.0);  // of each part: squared residuals, weights
    problem.forEachBlock([&](size_t part, size_t block, RowStore::Scratch& scratch) {
        forEachRow(problem, block, scratch, texels, plain, [&](const WeightedRow& row) {
            for (int c = 0; c < 3; ++c) {
                const float r = row.residual[c];
                const float bounded =
                    options.robust ? biweightLoss(r * std::sqrt(row.noiseWeight[c]), scale[c])
                                   : 1.0f;
                sums[2 * part] += static_cast<double>(row.sampleWeight[c] * bounded) *
                                  static_cast<double>(r) * static_cast<double>(r);
                sums[2 * part + 1] += static_cast<double>(row.noiseWeight[c]);
            }
        });
    });
    problem.options().ranks.sum(sums);
    double sum = 0.0, weight = 0.0;
    for (size_t part = 0; part < kParts; ++part) {
        sum += sums[2 * part];
        weight += sums[2 * part + 1];
    }
    return weight > 0.0 ? sum / weight : 0.0;
}

}  // namespace fbrdf

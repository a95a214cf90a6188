#include "LeastSquares.h"

#include "Parallel.h"

#include <fbrdf/brdf/Error.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// Sums are made in this many parts whatever the number of threads, and added in order: the same
// bits everywhere.
constexpr size_t kParts = 4;
constexpr double kFirstOrder = 0.03;  // of a second difference: decides where there is no curvature
constexpr double kRidge = 1e-9;       // of the mean diagonal: fixes the gauge between factors
constexpr double kTukey = 4.685;      // 95 % efficiency for Gaussian noise (Beaton and Tukey 1974)
constexpr double kMadToSigma = 1.4826;
constexpr float kSmallestScale =
    1e-4f;  // log2: residuals of exact data are not outliers of each other
constexpr float kLn2 = 0.69314718056f;

struct Response {
    float residual, weight;
};

// phi(f), phi(g) and d phi / d log2 g of the two metrics; c is cos theta_i.
Response responseOf(Metric metric, float c, float logF, float logG)
{
    if (metric == Metric::log) return {logF - logG, 1.0f};
    const float f = c * std::exp2(logF), g = c * std::exp2(logG);
    const bool cube = metric == Metric::cubeRoot;
    const float phiF = cube ? std::cbrt(f) : std::log1p(f);
    const float phiG = cube ? std::cbrt(g) : std::log1p(g);
    const float slope = std::max(cube ? phiG * kLn2 / 3.0f : kLn2 * g / (1.0f + g), 1e-12f);
    return {(phiF - phiG) / slope, slope * slope};
}

float medianOf(std::vector<float>& values)
{
    if (values.empty()) return 0.0f;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

struct LeastSquares::Working {
    std::vector<Vec3f> residual, weight;
    std::vector<std::vector<Vec3f>> share;  ///< terms x samples; empty for one term
    bool sharedByChannels = true;           ///< all channels have the same weights and shares
};

struct LeastSquares::Normal {
    SymmetricMatrix matrix;
    std::vector<double> right;  ///< unknowns x channels
};

LeastSquares::LeastSquares(const Form& form, const Observations& observations, int threads)
    : form_(form),
      observations_(observations),
      layout_(form),
      smoothness_(smoothnessRows(form, layout_, kFirstOrder)),
      threads_(threads)
{
    for (const Term& term : form.terms)
        rows_.push_back(makeRows(form, layout_, term, observations.samples, threads));
}

State LeastSquares::flatState() const
{
    const size_t n = unknowns();
    State x(3 * n);
    for (size_t c = 0; c < 3; ++c) {
        std::vector<float> logs;
        for (size_t i = 0; i < observations_.samples.size(); ++i)
            if (observations_.weight[i][static_cast<int>(c)] > 0.0f)
                logs.push_back(observations_.logValue[i][static_cast<int>(c)]);
        const double level = static_cast<double>(medianOf(logs)) -
                             std::log2(static_cast<double>(form_.terms.size()));
        const auto factors = static_cast<double>(form_.terms[0].factors.size());
        std::fill_n(x.begin() + static_cast<std::ptrdiff_t>(c * n), n, level / factors);
    }
    return x;
}

LeastSquares::Working LeastSquares::workingAt(const State& x, const StepOptions& options) const
{
    const size_t count = observations_.samples.size(), n = unknowns(), terms = rows_.size();
    Working w;
    w.residual.resize(count);
    w.weight.resize(count);
    if (terms > 1) w.share.assign(terms, std::vector<Vec3f>(count));
    std::vector<Vec3f> texels(n);
    for (size_t i = 0; i < n; ++i) texels[i] = Vec3f(Vec3d(x[i], x[n + i], x[2 * n + i]));
    parallelFor(count, threads_, [&](size_t i) {
        Vec3f logG(0.0f), sum(0.0f);
        for (size_t t = 0; t < terms; ++t) {
            const auto width = static_cast<size_t>(rows_[t].width);
            Vec3f logTerm(0.0f);
            for (size_t k = i * width; k < (i + 1) * width; ++k)
                logTerm += rows_[t].weight[k] * texels[static_cast<size_t>(rows_[t].unknown[k])];
            logG = logTerm;
            if (terms == 1) break;
            w.share[t][i] = Vec3f(std::exp2(logTerm.x), std::exp2(logTerm.y), std::exp2(logTerm.z));
            sum += w.share[t][i];
        }
        if (terms > 1) {
            logG = Vec3f(std::log2(sum.x), std::log2(sum.y), std::log2(sum.z));
            for (size_t t = 0; t < terms; ++t) w.share[t][i] /= sum;
        }
        const Sample& sample = observations_.samples[i];
        const bool excluded = static_cast<int>(observations_.fold[i]) == options.excludedFold;
        for (int c = 0; c < 3; ++c) {
            const Response response =
                responseOf(options.metric, sample.wi.z, observations_.logValue[i][c], logG[c]);
            // A censored value pulls only a prediction that lies above the floor.
            const bool satisfied =
                ((observations_.censored[i] >> c) & 1) != 0 && response.residual >= 0.0f;
            w.residual[i][c] = response.residual;
            w.weight[i][c] =
                excluded || satisfied ? 0.0f : observations_.weight[i][c] * response.weight;
        }
    });
    if (options.robust) applyTukey(w);
    w.sharedByChannels =
        terms == 1 && std::all_of(w.weight.begin(), w.weight.end(),
                                  [](const Vec3f& v) { return v.x == v.y && v.y == v.z; });
    return w;
}

// Beaton and Tukey 1974: weight (1 - (r / (c s))^2)^2 within c s, 0 beyond; s from the median of
// |r|. Residuals count in units of their expected noise, which is what the square root of the
// observation's weight measures.
void LeastSquares::applyTukey(Working& w) const
{
    for (int c = 0; c < 3; ++c) {
        std::vector<float> magnitudes;
        for (size_t i = 0; i < w.residual.size(); ++i)
            if (w.weight[i][c] > 0.0f)
                magnitudes.push_back(std::abs(w.residual[i][c]) *
                                     std::sqrt(observations_.weight[i][c]));
        const float scale =
            std::max(medianOf(magnitudes) * static_cast<float>(kMadToSigma), kSmallestScale);
        const float cut = static_cast<float>(kTukey) * scale;
        for (size_t i = 0; i < w.residual.size(); ++i) {
            const float ratio =
                std::abs(w.residual[i][c]) * std::sqrt(observations_.weight[i][c]) / cut;
            const float biweight = ratio < 1.0f ? 1.0f - ratio * ratio : 0.0f;
            w.weight[i][c] *= biweight * biweight;
        }
    }
}

LeastSquares::Normal LeastSquares::accumulate(const Working& w, int firstChannel,
                                              int channels) const
{
    const size_t n = unknowns(), count = w.residual.size(), terms = rows_.size();
    std::vector<Normal> parts(kParts);
    size_t widest = 0;
    for (const RowSet& rows : rows_) widest += static_cast<size_t>(rows.width);
    parallelTasks(kParts, threads_, [&](size_t part) {
        Normal& normal = parts[part];
        normal.matrix = SymmetricMatrix(n);
        normal.right.assign(n * static_cast<size_t>(channels), 0.0);
        std::vector<size_t> unknown(widest);
        std::vector<double> entry(widest);
        for (size_t i = count * part / kParts; i < count * (part + 1) / kParts; ++i) {
            const double weight = static_cast<double>(w.weight[i][firstChannel]);
            if (weight == 0.0) continue;
            size_t entries = 0;
            for (size_t t = 0; t < terms; ++t) {
                const double share =
                    terms == 1 ? 1.0 : static_cast<double>(w.share[t][i][firstChannel]);
                const auto width = static_cast<size_t>(rows_[t].width);
                for (size_t k = i * width; k < (i + 1) * width; ++k, ++entries) {
                    unknown[entries] = static_cast<size_t>(rows_[t].unknown[k]);
                    entry[entries] = share * static_cast<double>(rows_[t].weight[k]);
                }
            }
            for (size_t a = 0; a < entries; ++a) {
                double* row = &normal.matrix.lower[unknown[a] * n];
                const double scaled = weight * entry[a];
                for (size_t b = 0; b < entries; ++b)
                    if (unknown[b] <= unknown[a]) row[unknown[b]] += scaled * entry[b];
                for (int c = 0; c < channels; ++c)
                    normal.right[static_cast<size_t>(c) * n + unknown[a]] +=
                        scaled * static_cast<double>(w.residual[i][firstChannel + c]);
            }
        }
    });
    for (size_t part = 1; part < kParts; ++part) {
        for (size_t i = 0; i < n * n; ++i) parts[0].matrix.lower[i] += parts[part].matrix.lower[i];
        for (size_t i = 0; i < parts[0].right.size(); ++i)
            parts[0].right[i] += parts[part].right[i];
    }
    return std::move(parts[0]);
}

// Each table's rows are scaled by the mean diagonal of its own unknowns, so that one strength suits
// a form whose tables differ in how many samples a texel sees.
void LeastSquares::addSmoothness(Normal& normal, const State& x, double strength,
                                 int firstChannel) const
{
    const size_t n = unknowns();
    const size_t channels = normal.right.size() / n;
    std::vector<double> scale(form_.tables.size(), 0.0);
    double overall = 0.0;
    for (size_t t = 0; t < scale.size(); ++t) {
        const int texels = texelCount(form_.tables[t].domain);
        for (int i = 0; i < texels; ++i) {
            const auto u = static_cast<size_t>(layout_.unknownOf(t, i));
            scale[t] += normal.matrix.at(u, u) / texels;
        }
        overall += scale[t] / static_cast<double>(scale.size());
    }
    for (const SmoothnessRow& row : smoothness_) {
        const double factor = strength * scale[static_cast<size_t>(row.table)];
        for (int a = 0; a < row.count; ++a) {
            const auto ua = static_cast<size_t>(row.unknown[a]);
            for (int b = 0; b < row.count; ++b) {
                const auto ub = static_cast<size_t>(row.unknown[b]);
                const double product = factor * row.weight[a] * row.weight[b];
                if (ub <= ua) normal.matrix.at(ua, ub) += product;
                for (size_t c = 0; c < channels; ++c)
                    normal.right[c * n + ua] -=
                        product * x[(static_cast<size_t>(firstChannel) + c) * n + ub];
            }
        }
    }
    for (size_t u = 0; u < n; ++u) normal.matrix.at(u, u) += kRidge * overall;
}

std::vector<State> LeastSquares::steps(const State& x, const StepOptions& options,
                                       const std::vector<double>& strengths) const
{
    const size_t n = unknowns();
    const Working working = workingAt(x, options);
    const int channels = working.sharedByChannels ? 3 : 1;
    std::vector<State> states(strengths.size(), x);
    for (int first = 0; first < 3; first += channels) {
        const Normal data = accumulate(working, first, channels);
        for (size_t s = 0; s < strengths.size(); ++s) {
            Normal normal = data;
            addSmoothness(normal, x, strengths[s], first);
            for (size_t u = 0; u < n; ++u) normal.matrix.at(u, u) *= 1.0 + options.damping;
            const Cholesky cholesky(normal.matrix);
            if (!cholesky.ok())
                throw Error(ErrorKind::fit, form_.name,
                            "the samples leave the system singular; expected directions that vary");
            cholesky.solve(normal.right.data(), static_cast<size_t>(channels));
            for (size_t i = 0; i < normal.right.size(); ++i)
                states[s][static_cast<size_t>(first) * n + i] += normal.right[i];
        }
    }
    return states;
}

State LeastSquares::step(const State& x, const StepOptions& options) const
{
    return steps(x, options, {options.smoothness})[0];
}

double LeastSquares::cost(const State& x, const StepOptions& options) const
{
    const Working w = workingAt(x, options);
    double sum = 0.0, weights = 0.0;
    for (size_t i = 0; i < w.residual.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double r = static_cast<double>(w.residual[i][c]),
                         weight = static_cast<double>(w.weight[i][c]);
            sum += weight * r * r;
            weights += static_cast<double>(observations_.weight[i][c]);
        }
    return weights > 0.0 ? sum / weights : 0.0;
}

double LeastSquares::foldError(const State& x, int fold) const
{
    const Working w = workingAt(x, {});
    double sum = 0.0, weights = 0.0;
    for (size_t i = 0; i < w.residual.size(); ++i) {
        if (fold != kNoFold && static_cast<int>(observations_.fold[i]) != fold) continue;
        for (int c = 0; c < 3; ++c) {
            if ((observations_.censored[i] >> c) & 1) continue;
            const double weight = static_cast<double>(w.weight[i][c]);
            sum += weight * std::abs(static_cast<double>(w.residual[i][c]));
            weights += weight;
        }
    }
    return weights > 0.0 ? sum / weights : 0.0;
}

}  // namespace fbrdf

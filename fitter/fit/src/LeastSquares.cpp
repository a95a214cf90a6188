#include "LeastSquares.h"

#include "Parallel.h"

#include <fbrdf/brdf/Error.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf {
namespace {

// Sums are made in this many parts whatever the number of threads, and added in order: the same
// bits everywhere.
constexpr size_t kParts = 4;
constexpr double kFirstOrder = 0.03;  // of a second difference: decides where there is no curvature
constexpr double kRidge = 1e-11;      // of the mean diagonal: fixes the gauge between factors
constexpr float kTukey = 4.685f;      // 95 % efficiency for Gaussian noise (Beaton and Tukey 1974)
constexpr float kMadToSigma = 1.4826f;
constexpr float kSmallestScale =
    1e-4f;                           // log2: residuals of exact data are not outliers of each other
constexpr size_t kScaleBlocks = 24;  // blocks that the scale of the residuals is taken from
constexpr float kLn2 = 0.69314718056f;

struct Response {
    float residual, weight;
};

// phi(f), phi(g) and d phi / d log2 g of the metrics; c is cos theta_i.
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

}  // namespace

/// What a visitor of rows sees of one sample.
struct LeastSquares::Part {
    const int* unknown;
    const float* weight;
    Vec3f residual, sampleWeight, noiseWeight;
    const Vec3f* share;  ///< one a term
    uint64_t number;
};

struct LeastSquares::Normal {
    SymmetricMatrix matrix;
    std::vector<double> right;  ///< unknowns x channels
};

LeastSquares::LeastSquares(Form form, Feed feed, const DataTraits& traits, uint64_t seed,
                           int threads)
    : form_(std::move(form)),
      feed_(std::move(feed)),
      traits_(traits),
      layout_(form_),
      rows_(form_, layout_),
      smoothness_(smoothnessRows(form_, layout_, kFirstOrder)),
      seed_(seed),
      threads_(threads)
{
}

LeastSquares LeastSquares::thinned(size_t stride) const
{
    Feed thin = feed_;
    thin.blocks = (feed_.blocks + stride - 1) / stride;
    thin.read = [read = feed_.read, stride](size_t block, std::vector<Sample>& scratch) {
        return read(block * stride, scratch);
    };
    return LeastSquares(form_, std::move(thin), traits_, seed_, threads_);
}

LeastSquares LeastSquares::withForm(const Form& form) const
{
    return LeastSquares(form, feed_, traits_, seed_, threads_);
}

State LeastSquares::flatState() const
{
    const size_t n = unknowns();
    State x(3 * n);
    std::vector<size_t> lastTerm(form_.tables.size(), 0);
    for (size_t t = 0; t < form_.terms.size(); ++t)
        for (const Factor& factor : form_.terms[t].factors)
            lastTerm[static_cast<size_t>(factor.table)] = t;
    for (size_t table = 0; table < form_.tables.size(); ++table) {
        const Term& term = form_.terms[lastTerm[table]];
        const bool isLast = lastTerm[table] + 1 == form_.terms.size();
        const Vec3f level =
            (isLast ? traits_.level : traits_.low) / static_cast<float>(term.factors.size());
        for (int i = 0; i < texelCount(form_.tables[table].domain); ++i)
            for (size_t c = 0; c < 3; ++c)
                x[c * n + static_cast<size_t>(layout_.unknownOf(table, i))] =
                    static_cast<double>(level[static_cast<int>(c)]);
    }
    return x;
}

template <class Visit>
void LeastSquares::forEachRow(size_t part, const State& x, const StepOptions& options,
                              const Visit& visit) const
{
    const size_t n = unknowns(), terms = form_.terms.size();
    std::vector<Vec3f> texels(n), share(terms);
    for (size_t i = 0; i < n; ++i) texels[i] = Vec3f(Vec3d(x[i], x[n + i], x[2 * n + i]));
    std::vector<int> unknown(static_cast<size_t>(rows_.width()));
    std::vector<float> weight(unknown.size());
    std::vector<Sample> scratch;
    for (size_t b = feed_.blocks * part / kParts; b < feed_.blocks * (part + 1) / kParts; ++b) {
        const FeedBlock block = feed_.read(b, scratch);
        for (size_t i = 0; i < block.count; ++i) {
            if (options.excludedFold != kNoFold &&
                foldOf(block.first + i, seed_) == options.excludedFold)
                continue;
            const Sample& sample = block.samples[i];
            rows_.make(sample, unknown.data(), weight.data());
            Vec3f logG(0.0f);
            size_t k = 0;
            Vec3f sum(0.0f);
            for (size_t t = 0; t < terms; ++t) {
                logG = Vec3f(0.0f);
                for (; k < static_cast<size_t>(rows_.termEnd()[t]); ++k)
                    logG += weight[k] * texels[static_cast<size_t>(unknown[k])];
                share[t] = Vec3f(1.0f);
                if (terms == 1) break;
                share[t] = Vec3f(std::exp2(logG.x), std::exp2(logG.y), std::exp2(logG.z));
                sum += share[t];
            }
            if (terms > 1) {
                logG = Vec3f(std::log2(sum.x), std::log2(sum.y), std::log2(sum.z));
                for (Vec3f& s : share) s /= sum;
            }
            Part row{unknown.data(), weight.data(), Vec3f(0.0f),    Vec3f(0.0f),
                     Vec3f(0.0f),    share.data(),  block.first + i};
            for (int c = 0; c < 3; ++c) {
                const Observed o = observe(sample.f[c], traits_.floor[c], sample.weight);
                if (o.weight == 0.0f) continue;
                const Response response =
                    responseOf(options.metric, sample.wi.z, o.logValue, logG[c]);
                row.residual[c] = response.residual;
                row.noiseWeight[c] = o.weight;
                row.sampleWeight[c] =
                    o.censored && response.residual >= 0.0f ? 0.0f : o.weight * response.weight;
            }
            visit(row);
        }
    }
}

// Scale s of the residuals from the median of their magnitudes, in units of the expected noise.
Vec3f LeastSquares::tukeyScale(const State& x, const StepOptions& options) const
{
    const LeastSquares sparse = thinned(std::max<size_t>(1, feed_.blocks / kScaleBlocks));
    std::array<std::array<std::vector<float>, 3>, kParts> magnitudes;
    parallelTasks(kParts, threads_, [&](size_t part) {
        sparse.forEachRow(part, x, options, [&](const Part& row) {
            for (int c = 0; c < 3; ++c)
                if (row.sampleWeight[c] > 0.0f)
                    magnitudes[part][static_cast<size_t>(c)].push_back(
                        std::abs(row.residual[c]) * std::sqrt(row.noiseWeight[c]));
        });
    });
    Vec3f scale;
    for (size_t c = 0; c < 3; ++c) {
        std::vector<float> all;
        for (const auto& part : magnitudes) all.insert(all.end(), part[c].begin(), part[c].end());
        scale[static_cast<int>(c)] = std::max(quantile(all, 0.5) * kMadToSigma, kSmallestScale);
    }
    return scale;
}

LeastSquares::Normal LeastSquares::accumulate(const State& x, const StepOptions& options,
                                              const Vec3f& scale, int firstChannel,
                                              int channels) const
{
    const size_t n = unknowns(), terms = form_.terms.size();
    std::vector<Normal> parts(kParts);
    parallelTasks(kParts, threads_, [&](size_t part) {
        Normal& normal = parts[part];
        normal.matrix = SymmetricMatrix(n);
        normal.right.assign(n * static_cast<size_t>(channels), 0.0);
        std::vector<double> entry(static_cast<size_t>(rows_.width()));
        forEachRow(part, x, options, [&](const Part& row) {
            double weight = static_cast<double>(row.sampleWeight[firstChannel]);
            if (options.robust) {
                // Beaton and Tukey 1974: (1 - (r / (c s))^2)^2 within c s, 0 beyond.
                const float ratio = std::abs(row.residual[firstChannel]) *
                                    std::sqrt(row.noiseWeight[firstChannel]) /
                                    (kTukey * scale[firstChannel]);
                const double biweight = static_cast<double>(std::max(0.0f, 1.0f - ratio * ratio));
                weight *= biweight * biweight;
            }
            if (weight == 0.0) return;
            size_t k = 0;
            for (size_t t = 0; t < terms; ++t)
                for (; k < static_cast<size_t>(rows_.termEnd()[t]); ++k)
                    entry[k] = static_cast<double>(row.share[t][firstChannel] * row.weight[k]);
            for (size_t a = 0; a < entry.size(); ++a) {
                const auto ua = static_cast<size_t>(row.unknown[a]);
                double* matrixRow = &normal.matrix.lower[ua * n];
                const double scaled = weight * entry[a];
                for (size_t b = 0; b < entry.size(); ++b) {
                    const auto ub = static_cast<size_t>(row.unknown[b]);
                    if (ub <= ua) matrixRow[ub] += scaled * entry[b];
                }
                for (int c = 0; c < channels; ++c)
                    normal.right[static_cast<size_t>(c) * n + ua] +=
                        scaled * static_cast<double>(row.residual[firstChannel + c]);
            }
        });
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
    // A channel without a single value above the floor leaves everything to the smoothness.
    if (overall == 0.0) overall = 1.0;
    for (double& s : scale)
        if (s == 0.0) s = overall;
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
    const Vec3f scale = options.robust ? tukeyScale(x, options) : Vec3f(1.0f);
    const bool shared = traits_.sameWeights && !options.robust && form_.terms.size() == 1 &&
                        options.metric == Metric::log;
    const int channels = shared ? 3 : 1;
    std::vector<State> states(strengths.size(), x);
    for (int first = 0; first < (traits_.grey ? 1 : 3); first += channels) {
        const Normal data = accumulate(x, options, scale, first, channels);
        for (size_t s = 0; s < strengths.size(); ++s) {
            Normal normal = data;
            addSmoothness(normal, x, strengths[s], first);
            for (size_t u = 0; u < n; ++u) normal.matrix.at(u, u) *= 1.0 + options.damping;
            const Cholesky cholesky(std::move(normal.matrix));
            if (!cholesky.ok())
                throw Error(ErrorKind::fit, form_.name,
                            "the samples leave the system singular; expected directions that vary");
            cholesky.solve(normal.right.data(), static_cast<size_t>(channels));
            for (size_t i = 0; i < normal.right.size(); ++i)
                states[s][static_cast<size_t>(first) * n + i] += normal.right[i];
        }
    }
    if (traits_.grey && channels == 1)
        for (State& state : states)
            for (size_t i = n; i < 3 * n; ++i) state[i] = state[i - n];
    return states;
}

State LeastSquares::step(const State& x, const StepOptions& options) const
{
    return steps(x, options, {options.smoothness})[0];
}

template <class Value>
double LeastSquares::weightedMean(const State& x, const StepOptions& options,
                                  const Value& value) const
{
    std::array<double, kParts> sums{}, weights{};
    parallelTasks(kParts, threads_, [&](size_t part) {
        forEachRow(part, x, options, [&](const Part& row) {
            for (int c = 0; c < 3; ++c) {
                const auto [sum, weight] = value(row, c);
                sums[part] += sum;
                weights[part] += weight;
            }
        });
    });
    double sum = 0.0, weight = 0.0;
    for (size_t part = 0; part < kParts; ++part) {
        sum += sums[part];
        weight += weights[part];
    }
    return weight > 0.0 ? sum / weight : 0.0;
}

double LeastSquares::cost(const State& x, const StepOptions& options) const
{
    return weightedMean(x, options, [](const Part& row, int c) {
        const auto r = static_cast<double>(row.residual[c]);
        return std::pair(static_cast<double>(row.sampleWeight[c]) * r * r,
                         static_cast<double>(row.noiseWeight[c]));
    });
}

double LeastSquares::foldError(const State& x, int fold) const
{
    return weightedMean(x, {}, [&](const Part& row, int c) {
        const bool counts = fold == kNoFold || foldOf(row.number, seed_) == fold;
        const double weight = counts ? static_cast<double>(row.sampleWeight[c]) : 0.0;
        return std::pair(weight * std::abs(static_cast<double>(row.residual[c])), weight);
    });
}

}  // namespace fbrdf

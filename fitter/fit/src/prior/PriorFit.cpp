#include "prior/PriorFit.h"

#include "prior/PriorSample.h"

#include <fbrdf/base/Assert.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

using Index = Eigen::Index;

constexpr Index kManySamples = 200;   // above: fewer weights are tried
constexpr double kLeastPivot = 1e-9;  // of the compressed samples, relative

/// Samples with their weights multiplied in: as many of variance noise^2, and others that the
/// unknowns cannot change.
struct WeighedSamples {
    PriorMatrix rows;       ///< samples x unknowns
    PriorMatrix residuals;  ///< samples x 3: log2 f less what the mean predicts
    double others = 0;      ///< how many were combined with these
    double rest = 0;        ///< the sum of their squared residuals over the channels
};

float valueOf(const RowStore::Block& block, size_t i, int c)
{
    return std::exp2(block.values.logValue[i][c]);
}

double weightOf(const RowStore::Block& block, size_t i)
{
    double mean = 0.0, sample = 0.0;
    for (int c = 0; c < 3; ++c) {
        const bool isCensored = (block.values.censored[i] >> c & 1) != 0;
        mean += isCensored ? 0.0 : static_cast<double>(valueOf(block, i, c)) / 3.0;
        sample = std::max(sample, static_cast<double>(block.values.weight[i][c]));
    }
    return sample * weightOfPriorSample(mean);
}

/// Visits the samples that take part, in order.
template <class Visit>
void forEachSample(const LeastSquares& problem, int excludedFold, const Visit& visit)
{
    RowStore::Scratch scratch;
    for (size_t b = 0; b < problem.store().blocks(); ++b) {
        const RowStore::Block block = problem.store().block(b, scratch);
        for (size_t i = 0; i < block.geometry.count; ++i) {
            if (excludedFold != kNoFold &&
                foldOf(block.geometry.number(i), problem.seed()) == excludedFold)
                continue;
            visit(block, i);
        }
    }
}

WeighedSamples weighed(const LeastSquares& problem, const PriorCovariance& prior, int excludedFold)
{
    const auto width = static_cast<size_t>(problem.maker().width());
    WeighedSamples samples;
    samples.rows = PriorMatrix::Zero(static_cast<Index>(problem.rows()), prior.mean.size());
    samples.residuals = PriorMatrix::Zero(samples.rows.rows(), 3);
    Index count = 0;
    forEachSample(problem, excludedFold, [&](const RowStore::Block& block, size_t i) {
        const double root = std::sqrt(weightOf(block, i));
        auto row = samples.rows.row(count);
        for (size_t k = i * width; k < (i + 1) * width; ++k)
            row(block.geometry.unknown[k]) += root * static_cast<double>(block.geometry.weight[k]);
        for (int c = 0; c < 3; ++c)
            samples.residuals(count, c) =
                root * log2OfPriorSample(static_cast<double>(valueOf(block, i, c))) -
                row.dot(prior.mean);
        ++count;
    });
    samples.rows.conservativeResize(count, Eigen::NoChange);
    samples.residuals.conservativeResize(count, Eigen::NoChange);
    return samples;
}

// More samples than unknowns, as the Cholesky factor of their normal equations: as many rows as
// unknowns give the same equations.
WeighedSamples compressed(const WeighedSamples& samples)
{
    const Index unknowns = samples.rows.cols();
    PriorMatrix normal = PriorMatrix::Zero(unknowns, unknowns);
    normal.selfadjointView<Eigen::Lower>().rankUpdate(samples.rows.transpose());
    normal.diagonal().array() += kLeastPivot * normal.diagonal().mean();
    const Eigen::LLT<PriorMatrix> cholesky(normal);
    WeighedSamples result;
    result.rows = cholesky.matrixU();
    result.residuals = cholesky.matrixL().solve(samples.rows.transpose() * samples.residuals);
    result.others = static_cast<double>(samples.rows.rows() - unknowns);
    result.rest = std::max(0.0, samples.residuals.squaredNorm() - result.residuals.squaredNorm());
    return result;
}

/// The covariances of the samples without noise, and their evidence for weights.
class Evidence {
public:
    Evidence(const WeighedSamples& samples, const PriorCovariance& prior)
        : samples_(samples),
          inModes_(samples.rows * prior.modes),
          inRoot_(prior.root.triangularView<Eigen::Lower>() * samples.rows.transpose())
    {
        const Index n = samples.rows.rows();
        ofModes_ = PriorMatrix::Zero(n, n);
        ofModes_.selfadjointView<Eigen::Lower>().rankUpdate(inModes_);
        ofSmoothness_ = PriorMatrix::Zero(n, n);
        ofSmoothness_.selfadjointView<Eigen::Lower>().rankUpdate(inRoot_.transpose());
    }

    const PriorMatrix& inModes() const { return inModes_; }  ///< samples x modes
    const PriorMatrix& inRoot() const { return inRoot_; }    ///< unknowns x samples

    Eigen::LLT<PriorMatrix> factored(const PriorWeights& weights) const
    {
        PriorMatrix covariance = ofModes_ + weights.tau * weights.tau * ofSmoothness_;
        covariance.diagonal().array() += weights.noise * weights.noise;
        return Eigen::LLT<PriorMatrix>(covariance);
    }

    double operator()(const PriorWeights& weights) const
    {
        const Eigen::LLT<PriorMatrix> cholesky = factored(weights);
        const double variance = weights.noise * weights.noise;
        const double logDeterminant = 2.0 * cholesky.matrixLLT().diagonal().array().log().sum() +
                                      samples_.others * std::log(variance);
        const double misfit =
            cholesky.matrixL().solve(samples_.residuals).squaredNorm() + samples_.rest / variance;
        return -0.5 * (misfit + 3.0 * logDeterminant);
    }

private:
    const WeighedSamples& samples_;
    PriorMatrix inModes_, inRoot_, ofModes_, ofSmoothness_;
};

const std::vector<double> kTau{0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0},
    kNoise{0.01, 0.02, 0.05, 0.1, 0.2};

// The neighbours of the best on the ladders are tried until none is better.
class WeightSearch {
public:
    WeightSearch(const Evidence& evidence, int threads)
        : evidence_(evidence),
          threads_(threads),
          known_(kTau.size() * kNoise.size(), std::numeric_limits<double>::quiet_NaN())
    {
    }

    PriorWeights best()
    {
        size_t at = placeOf(kTau.size() / 2, kNoise.size() / 2);
        for (;;) {
            tryAround(at);
            const size_t next = bestPlace();
            if (next == at) return weightsAt(at);
            at = next;
        }
    }
    PriorWeights bestOfAll()
    {
        std::vector<size_t> all(known_.size());
        for (size_t i = 0; i < all.size(); ++i) all[i] = i;
        tryThose(all);
        return weightsAt(bestPlace());
    }

private:
    static size_t placeOf(size_t tau, size_t noise) { return tau * kNoise.size() + noise; }
    static PriorWeights weightsAt(size_t place)
    {
        return {kTau[place / kNoise.size()] * kOctave, kNoise[place % kNoise.size()] * kOctave};
    }
    void tryThose(std::vector<size_t> places)
    {
        places.erase(std::remove_if(places.begin(), places.end(),
                                    [this](size_t p) { return !std::isnan(known_[p]); }),
                     places.end());
        parallelTasks(places.size(), threads_,
                      [&](size_t i) { known_[places[i]] = evidence_(weightsAt(places[i])); });
    }
    void tryAround(size_t at)
    {
        const size_t tau = at / kNoise.size(), noise = at % kNoise.size();
        std::vector<size_t> places;
        for (size_t t = tau - std::min<size_t>(tau, 1); t <= std::min(tau + 1, kTau.size() - 1);
             ++t)
            for (size_t s = noise - std::min<size_t>(noise, 1);
                 s <= std::min(noise + 1, kNoise.size() - 1); ++s)
                places.push_back(placeOf(t, s));
        tryThose(places);
    }
    size_t bestPlace() const
    {
        size_t best = known_.size();
        for (size_t i = 0; i < known_.size(); ++i)
            if (!std::isnan(known_[i]) && (best == known_.size() || known_[i] > known_[best]))
                best = i;
        return best;
    }

    const Evidence& evidence_;
    int threads_;
    std::vector<double> known_;
};

PriorWeights bestWeights(const Evidence& evidence, const WeighedSamples& samples, int threads)
{
    WeightSearch search(evidence, threads);
    return samples.rows.rows() > kManySamples ? search.best() : search.bestOfAll();
}

}  // namespace

PriorFit fitWithPrior(const LeastSquares& problem, const PriorCovariance& prior, int excludedFold,
                      const std::optional<PriorWeights>& weights)
{
    FBRDF_ASSERT(problem.unknowns(), ==, static_cast<size_t>(prior.mean.size()));
    FBRDF_ASSERT(problem.columns(), ==, size_t{3});
    WeighedSamples samples = weighed(problem, prior, excludedFold);
    if (samples.rows.rows() > samples.rows.cols()) samples = compressed(samples);
    const Evidence evidence(samples, prior);
    PriorFit fit;
    fit.weights = weights ? *weights : bestWeights(evidence, samples, problem.threads());
    const PriorMatrix dual = evidence.factored(fit.weights).solve(samples.residuals);
    const PriorMatrix inModes = evidence.inModes().transpose() * dual;
    const PriorMatrix inRoot = evidence.inRoot() * dual;
    PriorMatrix x = prior.root.transpose().triangularView<Eigen::Upper>() * inRoot;
    x *= fit.weights.tau * fit.weights.tau;
    x += prior.mean.replicate(1, 3) + prior.modes * inModes;
    fit.x.assign(x.data(), x.data() + x.size());
    fit.distance = inModes.squaredNorm() / static_cast<double>(std::max<Index>(1, inModes.size()));
    return fit;
}

}  // namespace fbrdf

#include "prior/PriorFit.h"

#include "prior/PriorSample.h"
#include "prior/PriorSystem.h"

#include <fbrdf/base/Assert.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

using Index = Eigen::Index;

constexpr size_t kManySamples = 200;  // above: evidence has one summit

const std::vector<double> kTau{0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0},
    kNoise{0.01, 0.02, 0.05, 0.1, 0.2};

// The neighbours of the best on the ladders are tried until none is better.
class WeightSearch {
public:
    WeightSearch(const PriorSystem& system, int threads)
        : system_(system),
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
        parallelTasks(places.size(), threads_, [&](size_t i) {
            known_[places[i]] = system_.posterior(weightsAt(places[i])).evidence;
        });
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

    const PriorSystem& system_;
    int threads_;
    std::vector<double> known_;
};

PriorWeights bestWeights(const PriorSystem& system, const LeastSquares& problem)
{
    WeightSearch search(system, problem.threads());
    return problem.rows() > kManySamples ? search.best() : search.bestOfAll();
}

}  // namespace

PriorFit fitWithPrior(const LeastSquares& problem, const PriorCovariance& prior, int excludedFold,
                      const std::optional<PriorWeights>& weights)
{
    FBRDF_ASSERT(problem.columns(), ==, size_t{3});
    const PriorSystem system(problem, prior, excludedFold);
    PriorFit fit;
    fit.weights = weights ? *weights : bestWeights(system, problem);
    const PriorSystem::Posterior posterior = system.posterior(fit.weights);
    const PriorMatrix x = prior.mean.replicate(1, 3) + prior.modes * posterior.z + posterior.e;
    fit.x.assign(x.data(), x.data() + x.size());
    fit.distance =
        posterior.z.squaredNorm() / static_cast<double>(std::max<Index>(1, posterior.z.size()));
    return fit;
}

}  // namespace fbrdf

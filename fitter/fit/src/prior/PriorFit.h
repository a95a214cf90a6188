// PriorFit.h - the most probable log tables of few samples under a prior.
#pragma once
#include "prior/PriorCovariance.h"
#include "solve/LeastSquares.h"

#include <optional>

namespace fbrdf {

/// Two numbers that the samples of each material decide, in octaves.
struct PriorWeights {
    double tau = 0;    ///< by how much tables leave the modes of the prior
    double noise = 0;  ///< standard deviation of one sample, of log2 f
};

struct PriorFit {
    State x;
    PriorWeights weights;
    /// Mean over channels of squared coordinates in the modes, one for each mode: about 1 for
    /// materials such as the prior was learned from.
    double distance = 0;
};

/// The mean of the posterior of x for the weights of most evidence, log p(samples | weights), one
/// pair for all channels (MacKay 1992, "Bayesian Interpolation", section 3). Samples of
/// `excludedFold` take no part. A sample f counts (m / (m + 0.001))^2, m the mean of its channels
/// in 1/sr, so that what is black need not be black to a percent. Precondition: the problem has
/// the prior's form, and no shared shape. With `weights` it searches none.
PriorFit fitWithPrior(const LeastSquares& problem, const PriorCovariance& prior, int excludedFold,
                      const std::optional<PriorWeights>& weights);

}  // namespace fbrdf

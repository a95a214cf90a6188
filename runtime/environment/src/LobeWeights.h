// LobeWeights.h - the weights of a few lobes: small least squares whose unknowns are not negative.
#pragma once
#include <fbrdf/brdf/LobeTable.h>

#include <array>

namespace fbrdf {

constexpr int kMostWeights = kMostLobes + 1;  ///< and the cosine

/// Minimizes w^T gram w - 2 w^T right over w >= 0.
struct WeightProblem {
    int count = 0;
    std::array<std::array<double, kMostWeights>, kMostWeights> gram{};
    std::array<double, kMostWeights> right{};
};
using Weights = std::array<double, kMostWeights>;

/// The value that is minimized.
double objective(const WeightProblem& problem, const Weights& weights);

/// A minimum to within 1e-3 of it or so, in few steps: for comparing thousands of candidates.
Weights roughWeights(const WeightProblem& problem);

/// The minimum among those whose weights add up to `sum`, exactly: every set of positive weights is
/// tried. sum >= 0.
Weights weightsOfSum(const WeightProblem& problem, double sum);

}  // namespace fbrdf

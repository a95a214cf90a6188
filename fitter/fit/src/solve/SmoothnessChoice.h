// SmoothnessChoice.h - how strong the smoothness should be: what predicts best the samples that are
// left out.
#pragma once
#include "solve/Steps.h"

namespace fbrdf {

struct SmoothnessChoice {
    State x;  ///< after the step with the strength chosen, on all samples
    double smoothness;
};

/// The step with the strength that does best on samples left out, each of `folds` in turn; the
/// smoothness of `options` does not count. The rows are added up once for all strengths. Of many
/// samples about 262,144 are left out and compared. Of strengths that are within 2 % of the best
/// the strongest is chosen.
/// Preconditions: the problem is not large; `folds` do not contain options.excludedFold.
SmoothnessChoice stepWithBest(const LeastSquares& problem, const State& x,
                              const StepOptions& options, const Vec3f& scale,
                              const std::vector<double>& strengths, const std::vector<int>& folds);

}  // namespace fbrdf

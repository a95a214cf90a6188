// Solve.h - one form, all steps: the plain solution, robust reweighting, Gauss-Newton for sums and
// other metrics.
#pragma once
#include "solve/LeastSquares.h"

namespace fbrdf {

struct SolveOptions {
    double smoothness = 0;  ///< > 0: fixed; 0: by held-out error
    Metric metric = Metric::log;
    bool robust = false;
    int excludedFold = kNoFold;
    int folds = 1;  ///< that the smoothness is chosen by
};

struct Solution {
    State x;
    double smoothness = 0;
};

Solution solve(const LeastSquares& problem, const SolveOptions& options);

}  // namespace fbrdf

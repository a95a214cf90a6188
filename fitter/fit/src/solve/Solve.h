// Solve.h - all steps of one form: the plain solution, then the metric, then robust weights; sums
// and large forms start from a part of the samples and half of the texels.
#pragma once
#include "solve/Descent.h"

namespace fbrdf {

struct SolveOptions {
    double smoothness = 0;  ///< > 0: fixed; 0: by held-out error
    Metric metric = Metric::log;
    bool robust = false;
    int excludedFold = kNoFold;
    int folds = 1;  ///< that the smoothness is chosen by
};

/// Throws Error(fit) when a linear problem is singular beyond repair.
Solution solve(const LeastSquares& problem, const SolveOptions& options);

}  // namespace fbrdf

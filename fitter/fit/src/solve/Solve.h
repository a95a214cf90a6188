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
    /// The solution of the form for fewer samples of the same data, which sums and large forms
    /// start from; or, where a fold is left out and the smoothness is given, that for all samples:
    /// a few steps without the fold are taken from there. Null: nothing is known. Must outlive the
    /// call.
    const Solution* start = nullptr;
};

/// Throws Error(fit) when a linear problem is singular beyond repair.
Solution solve(const LeastSquares& problem, const SolveOptions& options);

}  // namespace fbrdf

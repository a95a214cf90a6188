// Descent.h - steps repeated until the cost of a problem stops falling.
#pragma once
#include "solve/Steps.h"

#include <fbrdf/fit/SolverSummary.h>

namespace fbrdf {

/// A state on its way down, and what has brought it there.
struct Solution {
    State x;
    double smoothness = 0.0;  ///< strength of the last step
    SolverSummary summary;
};

/// At most `planned` steps where a few are all that the state needs; without it
/// SolverOptions::maxSteps.
struct StepBudget {
    int planned = 0;
};

/// Levenberg-Marquardt from `start`, with the smoothness of `options`: a step that does not lower
/// the cost is taken back and damped ten times more. Ends as problem.options().limits state it.
Solution descend(const LeastSquares& problem, Solution start, const StepOptions& options,
                 const StepBudget& budget = {});

/// `count` steps of a problem that is linear but for its robust weights, which are taken anew
/// before each step (iteratively reweighted least squares).
Solution reweight(const LeastSquares& problem, Solution start, const StepOptions& options,
                  int count);

}  // namespace fbrdf

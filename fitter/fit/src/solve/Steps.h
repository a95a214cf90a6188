// Steps.h - one Gauss-Newton step of a problem, by systems that are factored or, where these would
// be too large, by preconditioned conjugate gradients.
#pragma once
#include "solve/ConjugateGradients.h"
#include "solve/SystemSums.h"

namespace fbrdf {

struct Step {
    State x;                          ///< the state after the step
    ConjugateGradientSummary system;  ///< of one that was factored: no iterations
};

/// The step from x. Throws Error(fit) when the system is singular beyond repair.
/// `scale`: that of robust weights, see residualScale; without it that at x.
Step step(const LeastSquares& problem, const State& x, const StepOptions& options,
          const Vec3f& scale);
Step step(const LeastSquares& problem, const State& x, const StepOptions& options);

/// Too large to be factored: steps take conjugate gradients, and stepWithBest (SmoothnessChoice.h)
/// is not for the problem.
bool isLarge(const LeastSquares& problem);

/// Moves the columns of x that `shared` serves by the solution of its system k.
void moveBy(const LeastSquares& problem, const SharedSystems& shared, size_t k, double strength,
            double damping, State& x);

/// Copies the first column into the others where the data are grey and only it was solved.
void repeatGrey(const LeastSquares& problem, State& x);

/// The change of a texel, in octaves, bounded for sums: where a term has a small share, the linear
/// step asks for changes that its share after the change does not justify.
double bounded(const LeastSquares& problem, double octaves);

}  // namespace fbrdf

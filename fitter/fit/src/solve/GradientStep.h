// GradientStep.h - the step of a large system by conjugate gradients: every iteration is a pass
// over the rows.
#pragma once
#include "solve/Steps.h"

namespace fbrdf {

/// Does what step() of Steps.h does. The limits of problem.options() state when the system counts
/// as solved.
Step gradientStep(const LeastSquares& problem, const State& x, const StepOptions& options,
                  const Vec3f& scale);

}  // namespace fbrdf

// GradientStep.h - the step of a large system by conjugate gradients: every iteration is a pass
// over the rows.
#pragma once
#include "solve/Steps.h"

namespace fbrdf {

/// As step() of Steps.h. The system counts as solved as problem.options().limits state it.
Step gradientStep(const LeastSquares& problem, const State& x, const StepOptions& options,
                  const Vec3f& scale);

}  // namespace fbrdf

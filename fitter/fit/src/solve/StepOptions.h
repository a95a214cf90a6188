// StepOptions.h - what one Gauss-Newton step is asked to do.
#pragma once
#include "data/Dataset.h"

#include <fbrdf/fit/Fit.h>

namespace fbrdf {

struct StepOptions {
    double smoothness = 1e-3;  ///< relative to the mean diagonal of the data's matrix
    double damping = 0.0;      ///< Levenberg-Marquardt, relative to the diagonal
    Metric metric = Metric::log;
    int excludedFold = kNoFold;  ///< samples of this fold take no part
    bool robust = false;         ///< Tukey biweight of the residuals at the current state
    /// The residuals are f / g - 1 of all values, zeros and negative ones too, in place of
    /// logarithms: right on average under noise, from a state that is near. Only where
    /// LeastSquares::hasWholeNoise().
    bool unbiased = false;
};

}  // namespace fbrdf

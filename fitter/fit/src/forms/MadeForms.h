// MadeForms.h - forms whose tables no least squares in logs gives: `svd`, singular values of the
// resampled function (Svd.h), and `analytic`, factors written down from a model
// (AnalyticFactors.h). Beside the forms of NamedForms.h they stand alone: no term of a sum, nothing
// that auto tries.
#pragma once
#include "Job.h"

#include <string>
#include <vector>

namespace fbrdf {

/// True for "analytic", "svd" and "svdN" with N terms. Throws Error(usage) for an N that no form
/// has.
bool isMadeForm(const std::string& name);

/// Throws Error(usage) for an option that says nothing of a made form.
void checkMadeOptions(const FitOptions& options);

/// The material, and its errors on samples that took no part: fresh pairs where the source is a
/// function, else folds of its samples. Throws Error(usage) where the form suits neither source nor
/// budget.
Fitted makeFitted(const Source& source, const Job& job);
SampleErrors madeHeldOutErrors(const Source& source, const Job& job, const Fitted& fitted);

}  // namespace fbrdf

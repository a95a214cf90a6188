// DirectForms.h - forms that are computed directly instead of fitted in log space: `svd`, singular
// values of the resampled function (Svd.h), and `analytic`, factors written down from a model
// (AnalyticFactors.h). Unlike the forms of NamedForms.h they are no terms of sums, and auto does
// not try them.
#pragma once
#include "FitContext.h"

#include <string>
#include <vector>

namespace fbrdf {

/// True for "analytic", "svd" and "svdN" with N terms. Throws Error(usage) for an N that no form
/// has.
bool isDirectForm(const std::string& name);

/// Throws Error(usage) for an option that direct forms do not have.
void checkDirectOptions(const FitOptions& options);

/// The material, and its errors on samples that took no part: fresh pairs where the source is a
/// function, else folds of its samples. Throws Error(usage) where the form suits neither source nor
/// budget.
Fitted fitDirectForm(const Source& source, const FitContext& context);
SampleErrors directHeldOutErrors(const Source& source, const FitContext& context,
                                 const Fitted& fitted);

}  // namespace fbrdf

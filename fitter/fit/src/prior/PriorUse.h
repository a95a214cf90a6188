// PriorUse.h - where a fit may lean on a prior.
#pragma once
#include "FitContext.h"

namespace fbrdf {

/// Whether a fit of the dataset may lean on a prior. It may not where the data are a function or
/// have kSmallSet samples or more; where several processes, a shared shape, another metric than
/// log, a smoothness, a size or another form than hdio, auto and best-of are asked for; or where
/// the prior's form has too many bytes or look-ups.
bool mayUsePrior(const Dataset& dataset, const FitOptions& options);

/// The prior of the options in the form that fits need it in; null where it may not be used.
std::shared_ptr<const PriorCovariance> priorFor(const FitContext& context);

}  // namespace fbrdf

// PriorUse.h - where a fit may lean on a prior.
#pragma once
#include "FitContext.h"

namespace fbrdf {

/// The prior of the options in the form that fits need it in; null where the context is not for it:
/// a function, kSmallSet samples or more, several processes, a shared shape, another metric than
/// log, a smoothness or a size that is asked for, or another form than hdio, auto and best-of.
std::shared_ptr<const PriorCovariance> priorFor(const FitContext& context);

}  // namespace fbrdf

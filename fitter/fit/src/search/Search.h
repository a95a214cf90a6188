// Search.h - `auto`: which form, sizes and warps suit the data within the budget.
//
// Coarse to fine, each trial one fit of at most 32,768 samples scored on a fold of them that took
// no part: the forms that have names, at the size that data and budget allow; then, of the best,
// the size of each table and the warp of each of its axes, one at a time (FormVariants.h). The
// winner and the named forms that came near it meet once more on all of the data. Depends on data,
// options and seed alone, not on the number of threads.
#pragma once
#include "Job.h"

namespace fbrdf {

/// The best fit, and a row of `trials` for every form that was tried. Throws Error(usage) when no
/// form stays within the options.
Fitted searchForm(const Source& source, const Job& job, std::vector<Trial>& trials);

/// The held-out error that decides: log_median, or that of the metric.
double scoreOf(const SampleErrors& errors, Metric metric);

}  // namespace fbrdf

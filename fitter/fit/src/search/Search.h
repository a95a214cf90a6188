// Search.h - `auto`: which form and sizes suit the data within the budget.
//
// The forms that have names, at the sizes that data and budget allow, are fitted to the data, to
// 32,768 samples of many, and compared by the errors that a person sees (SeenErrors.h) on samples
// held out, and on all where those are few. A difference within the spread of the parts of what is
// held out is none: then errors on all samples decide, and then the cost (Candidate.h). From a form
// that was found on many samples without noise the search goes on to the forms next to it, one
// table or axis at a time (Neighbours.h); on few or noisy ones only `best-of` does. Where samples
// are plenty, the best forms are then fitted to all and compared on all (Finals.h). The
// result depends on data, options and seed alone, not on the number of threads; with
// FitOptions::seconds also on what the machine did in that time.
#pragma once
#include "FitContext.h"

#include <string>
#include <vector>

namespace fbrdf {

/// The best fit, a row of `trials` for every form that was tried or left out for want of time, and
/// in `reason` why this one. Throws Error(usage) when no form stays within the options.
/// Of a form that is named: with a prior or without.
Fitted searchForm(const Source& source, const FitContext& context, std::vector<Trial>& trials,
                  std::string& reason);

}  // namespace fbrdf

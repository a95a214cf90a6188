// Race.h - the first stage of a search: the forms that have names, each at the size that data and
// budget allow.
#pragma once
#include "search/TrialRuns.h"

namespace fbrdf {

/// The forms that are within the options; those that have fallen behind for certain are left out of
/// the folds to come, and of the result (Maron and Moore 1994, "Hoeffding races").
std::vector<Candidate> race(TrialRuns& runs, const std::vector<std::string>& names);

}  // namespace fbrdf

// NamedTrials.h - the first stage of a search: the forms that have names, each at the size that
// data and budget allow.
#pragma once
#include "search/TrialRuns.h"

namespace fbrdf {

/// The names of the forms that suit the symmetries of the source, at most `terms` terms each. Forms
/// of one term, which take the least time, come first, then the most promising sums.
std::vector<std::string> candidateNames(const Source& source, int terms);

/// The forms that are within the options, tried.
std::vector<Candidate> tryNamed(TrialRuns& runs, const std::vector<std::string>& names);

}  // namespace fbrdf

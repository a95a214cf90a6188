// Finals.h - the last comparison of a search. On a part of many samples a form of many texels looks
// worse than it is, so the best forms are fitted to all of them.
#pragma once
#include "search/TrialRuns.h"

namespace fbrdf {

/// `best` and those of `others` of one term whose marks are near its own, fitted to all of the
/// data, the least mark first, until the time is up: at least `best`. Where there is a function,
/// the difference of pictures of the standard sphere is a quarter of each mark. Precondition:
/// runs.hasPlenty().
std::vector<Candidate> tryFinals(TrialRuns& runs, const BrdfFunction& function, Candidate best,
                                 std::vector<Candidate> others);

}  // namespace fbrdf

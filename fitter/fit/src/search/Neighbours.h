// Neighbours.h - the second stage of a search: from the best form to the forms next to it
// (FormVariants.h), one table or one axis at a time.
#pragma once
#include "search/TrialRuns.h"

namespace fbrdf {

/// Gives tables more texels where that lowers the errors, warps their axes, and takes back texels
/// that change nothing. With a resolution asked for, sizes stay.
void improve(TrialRuns& runs, Candidate& best);

}  // namespace fbrdf

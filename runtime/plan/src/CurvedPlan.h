// CurvedPlan.h - a plan whose last pass applies a curve (Transfer.h), which sums do not survive.
#pragma once
#include <fbrdf/plan/Plan.h>

namespace fbrdf {

/// plan: feasible. Where the last pass alone writes the target it takes the curve; several are sent
/// to the sum surface, and one more carries the sum to the target. Without an offscreen surface
/// several passes give a reason.
Plan curvedPlan(Plan plan, Transfer transfer, bool offscreen);

}  // namespace fbrdf

// CurvedPlan.h - a plan whose last pass applies a curve (Transfer.h), after which nothing may be
// added.
#pragma once
#include <fbrdf/plan/Plan.h>

namespace fbrdf {

/// Expects a feasible plan. If the last pass alone writes the target, it applies the curve;
/// otherwise the passes write the sum surface and one more pass carries the sum to the target.
/// Several passes without an offscreen surface give a reason instead.
Plan curvedPlan(Plan plan, Transfer transfer, bool offscreen);

}  // namespace fbrdf

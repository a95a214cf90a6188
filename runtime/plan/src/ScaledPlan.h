// ScaledPlan.h - a plan whose surfaces are UNORM: sums are scaled down to [0, 1], and up again
// where they are read.
#pragma once
#include <fbrdf/plan/Plan.h>

namespace fbrdf {

/// Expects a feasible plan that was made for RGBA32F surfaces and adds nothing to an offscreen
/// surface once that was multiplied. Sets gain and largest of every pass, and the surfaces' format.
Plan scaledPlan(Plan plan, const Form& form, const Peaks& peaks);

}  // namespace fbrdf

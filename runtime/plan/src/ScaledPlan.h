// ScaledPlan.h - a plan whose surfaces are UNORM or halves: sums are scaled down to [0, 1], and up
// again where they are read.
#pragma once
#include <fbrdf/plan/Plan.h>

namespace fbrdf {

/// Expects a feasible plan that was made for RGBA32F surfaces and adds nothing to an offscreen
/// surface once that was multiplied. Sets gain and largest of every pass, and the surfaces' format.
Plan scaledPlan(Plan plan, const Form& form, const Peaks& peaks, ColourFormat surfaces);

/// Scales a plan of RGBA32F surfaces for the first smaller format whose error is within
/// sumTolerance of what RGBA32F leaves; where there is none it stays. Either way it says why.
Plan withSmallestSum(Plan plan, const Form& form, const PlanRequest& request,
                     const Capabilities& capabilities);

}  // namespace fbrdf

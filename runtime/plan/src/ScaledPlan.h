// ScaledPlan.h - a plan whose surfaces are UNORM: sums are scaled down to what those can hold, and
// up again where they are read.
#pragma once
#include <fbrdf/plan/Plan.h>

namespace fbrdf {

/// plan: made as if its surfaces were RGBA32F, feasible, and nothing is added to an offscreen
/// surface once it was multiplied. Sets gain and largest of every pass, and the surfaces' format.
Plan scaledPlan(Plan plan, const Form& form, const Peaks& peaks);

}  // namespace fbrdf

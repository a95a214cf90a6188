// SamplePlan.h - the directions at which a material is best measured, few or many.
#pragma once
#include <fbrdf/fit/LearnPrior.h>

#include <string>
#include <vector>

namespace fbrdf {

/// Where a plan may put its directions.
enum class PlanSpace {
    hemisphere,       ///< anywhere
    planeOfIncidence  ///< wo in the plane of wi and the normal: what a simple goniometer reaches
};

/// Pairs of directions in the order in which each adds most to what is known: a plan of fewer
/// samples is a prefix. phi_h is 0.
using SamplePlan = std::vector<DirectionPair<double>>;

/// The next pair is the one that lowers the expected squared error of pictures most (greedy
/// A-optimal design; Fedorov 1972, "Theory of Optimal Experiments", section 2.7). Elevations are
/// above kMinElevation. Precondition: `known` has the prior's form. Throws Error(usage) for a
/// count above 5,000.
SamplePlan planSamples(const TablePrior& prior, const KnownMaterials& known, PlanSpace space,
                       size_t count);

/// The first `count` pairs of the plan that comes with the library; `fitter/prior.sh` made it.
/// Throws Error(usage) for 0 and for more than there are.
SamplePlan shippedPlan(PlanSpace space, size_t count);

/// A plan as text: a line "theta_h,theta_d,phi_d" and one for each pair, degrees.
std::string planText(const SamplePlan& plan);
/// Throws Error(input) naming `where` for anything else.
SamplePlan planFromText(std::string_view text, const std::string& where);

}  // namespace fbrdf

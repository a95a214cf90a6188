// SpreadPairs.h - pairs of directions that cover what a BRDF does, highlight included.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <vector>

namespace fbrdf {

/// `count` pairs, always the same, both directions at least 2 degrees above the horizon. Half are
/// cosine-distributed in wo and wi, half even in (sqrt theta_h, theta_d, phi_h, phi_d), which fills
/// the highlight. From the additive recurrence of the generalised golden ratio in 4 dimensions
/// (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences").
std::vector<DirectionPair<double>> spreadPairs(size_t count);

}  // namespace fbrdf

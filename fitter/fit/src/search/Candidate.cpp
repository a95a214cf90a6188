#include "search/Candidate.h"

#include <fbrdf/base/Assert.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {

bool Candidate::isFine() const
{
    constexpr double kFineScore = 2e-3, kFineCubeRoot = 5e-3;
    return score() < kFineScore && held.errors.cubeRootRms < kFineCubeRoot;
}

bool byScore(const Candidate& a, const Candidate& b)
{
    return a.score() < b.score();
}

double leastScore(const std::vector<Candidate>& candidates)
{
    FBRDF_ASSERT(candidates.size(), >, 0u);
    return std::min_element(candidates.begin(), candidates.end(), byScore)->score();
}

const Candidate& pick(const std::vector<Candidate>& candidates)
{
    const double least = leastScore(candidates);
    const Candidate* best = nullptr;
    for (const Candidate& c : candidates) {
        if (c.score() > least * kAllowed) continue;
        if (!best || c.bytes < best->bytes || (c.bytes == best->bytes && byScore(c, *best)))
            best = &c;
    }
    return *best;
}

// The median of n normal errors is known to 1.17 / sqrt(n), relative; two candidates err on the
// same samples, and much alike.
double slackOf(const HeldOut& held)
{
    constexpr double kSure = 4.0;
    return kSure / std::sqrt(static_cast<double>(std::max<size_t>(1, held.samples.size())));
}

}  // namespace fbrdf

// SampleFacts.h - what scattered samples show without a fit.
#pragma once
#include <fbrdf/sources/Source.h>

#include <cstdint>
#include <vector>

namespace fbrdf::tool {

/// Every n-th sample of a source, where n is the smallest number that leaves at most kMaxThinned
/// rows. `available` becomes the number of usable samples in all.
std::vector<Sample> thinnedSamples(const Source& source, uint64_t& available);
constexpr uint64_t kMaxThinned = 4'000'000;  // 160 MB: all of MERL, and more than errors need

/// What a single pass over a source shows, in memory that does not grow with it.
struct SampleSurvey {
    SampleReport report;
    uint64_t usable = 0;
    Vec3f least{0.0f}, most{0.0f};  ///< of all usable samples, by channel
    std::vector<Sample> thinned;    ///< at most kMaxSurveyed of them, evenly among all
};
SampleSurvey surveyOf(const Source& source);
constexpr uint64_t kMaxSurveyed = 500'000;  // 20 MB, whatever the size of a file

struct SampleReciprocity {
    double median = 0.0;    ///< median |ln f(a, b) / f(b, a)| over all channels above `floor`
    uint64_t lookedUp = 0;  ///< samples for which another was looked for
    uint64_t pairs = 0;     ///< samples (a, b) that have another near (b, a); 0: no median
};

/// Compares samples, at most kMostLookedUp evenly among all, with about the one nearest to each
/// after light and view are exchanged, within kSameDirection. `isotropic`: pairs that differ by a
/// rotation about the normal count as equal.
SampleReciprocity sampleReciprocity(const std::vector<Sample>& samples, bool isotropic,
                                    const Vec3f& floor);
/// Distance of unit directions (chords), both directions together, below which pairs count as the
/// same: about 2 degrees.
constexpr float kSameDirection = 0.035f;
/// A median over as many pairs is within 3 % of that over all.
constexpr size_t kMostLookedUp = 4000;

}  // namespace fbrdf::tool

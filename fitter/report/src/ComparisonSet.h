// ComparisonSet.h - the samples at which a report shows data against fit.
#pragma once
#include <fbrdf/metrics/Metrics.h>

#include <vector>

namespace fbrdf {

struct ComparisonSet {
    std::vector<Sample> samples;
    std::vector<Vec3f> fitted;  ///< the material at the samples' pairs
    bool measured = false;  ///< samples of the source's own; else its function at the uniform set
    uint64_t rows = 0;      ///< samples of the source, of which the set is an even choice
};

/// At most so many samples are shown; more of them change no picture.
constexpr size_t kShownSamples = 200000;

/// The source's own samples, evenly thinned to `most`; or its function at the uniform test set of
/// the metrics.
ComparisonSet comparisonSet(const Source& source, const Material& material,
                            size_t most = kShownSamples);

}  // namespace fbrdf

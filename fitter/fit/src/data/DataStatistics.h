// DataStatistics.h - statistics of the samples that a fit needs beforehand, and the logarithm and
// weight that a value gets from them.
//
// A value weighs f^2 / (f^2 + floor^2). One below the noise floor is censored: it is only known to
// lie below.
#pragma once
#include "data/Dataset.h"

#include <fbrdf/fit/Fit.h>

#include <string>
#include <vector>

namespace fbrdf {

struct DataStatistics {
    Vec3f floor{0.0f};  ///< noise floor, 1/sr; see floorOverCosine
    /// The noise is that of radiance: at incidence theta_i the floor is `floor` / cos theta_i.
    bool floorOverCosine = false;
    bool unclipped = false;    ///< negative values are kept: noise is seen on both sides of 0
    Vec3f level{0.0f};         ///< median of log2 f above the floor; 0 where a channel has none
    Vec3f low{0.0f};           ///< 10th percentile of log2 f above the floor
    bool exact = false;        ///< values of a function: those below the floor are raised to it
    bool sameWeights = false;  ///< no channel of any sample is at or below the floor
    bool grey = false;         ///< the channels of every sample are equal: one is solved for all
    size_t usable = 0;         ///< of the samples looked at, those with a channel above the floor
};

/// The noise floor of a channel at cos theta_i, 1/sr.
inline float floorAt(const DataStatistics& statistics, int channel, float cosine)
{
    return statistics.floorOverCosine ? statistics.floor[channel] / cosine
                                      : statistics.floor[channel];
}

/// Samples that a fit needs which leans on nothing else.
constexpr size_t kFewestSamples = 5;
/// And one that leans on a prior: a single sample fits whatever the prior says.
constexpr size_t kFewestWithPrior = 2;

/// Looks at `samples`, a fair part of the data; `exact`: values of a function, without noise.
/// Throws Error(fit) naming `source` when fewer than `fewest` samples have a value above the noise
/// floor.
DataStatistics statisticsOf(const std::vector<Sample>& samples, bool exact,
                            const std::string& source, size_t fewest = kFewestSamples);

struct StatisticsOptions {
    uint64_t seed = 1;  ///< of the part that is looked at
    int threads = 0;    ///< 0: one a core
    RankSum ranks;      ///< each process checks its share of the rows
    size_t fewest = kFewestSamples;
};
/// The statistics of a whole dataset: the floor and the levels from 65,536 samples spread over it,
/// while what must be true of every sample (sameWeights, grey) is checked on all of them. Throws as
/// above.
DataStatistics statisticsOf(const Dataset& dataset, const StatisticsOptions& options,
                            const std::string& source);

/// One channel of one sample.
struct Observed {
    float value;   ///< f, or the floor where censored; a normal number > 0
    float weight;  ///< the sample's own times that of the noise; 0: takes no part
    bool censored;
};
/// `cosine`: of theta_i.
Observed observe(float f, float cosine, const DataStatistics& statistics, int channel,
                 float sampleWeight);

/// The value below which `fraction` of the values lie; 0 of none. Reorders them.
float quantile(std::vector<float>& values, double fraction);

}  // namespace fbrdf

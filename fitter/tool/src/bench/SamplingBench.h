// SamplingBench.h - how far one random direction is from the light that a material reflects: drawn
// from its lobes, and from the best diffuse and GGX.
#pragma once
#include "bench/BenchFit.h"

#include <fbrdf/peers/GgxSampling.h>

#include <string>
#include <vector>

namespace fbrdf::tool {

struct SamplingScore {
    std::string source;
    std::string form;        ///< the material whose light it is
    double deviation = 0.0;  ///< ReflectedLight::deviation of its lobes
    GgxSamplingFit ggx;      ///< the best for this material
    std::string error;       ///< why there are no numbers; empty where there are
    bool isLower() const { return error.empty() && deviation < ggx.deviation; }
    bool isLowerThanFree() const { return error.empty() && deviation < ggx.deviationOfFreeShares; }
};

/// Fits `form` to each source and samples the material as it is stored.
std::vector<SamplingScore> scoreSampling(const std::vector<std::string>& sources,
                                         const Contender& form, const BenchOptions& options,
                                         Progress& progress);

std::string samplingText(const std::vector<SamplingScore>& scores);
Json samplingJson(const std::vector<SamplingScore>& scores);

}  // namespace fbrdf::tool

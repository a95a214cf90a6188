// AreaBench.h - how well lobes stand for materials under area lights.
#pragma once
#include "Errors.h"
#include "Progress.h"

#include <fbrdf/metrics/AreaSphere.h>
#include <fbrdf/sources/OpenSource.h>

#include <string>
#include <vector>

namespace fbrdf::tool {

struct AreaBenchOptions {
    std::vector<int> lobes{1, 2, 3};  ///< tilted ones; of anisotropic sources 1, 3 and 7 normals
    int size = 64;                    ///< pixels across the sphere
    int threads = 0;
    SourceOptions source;
};

struct AreaScore {
    std::string label;                       ///< "K = 2"
    std::vector<AreaSphere::Errors> errors;  ///< of each light
};

struct AreaScores {
    std::string source;
    std::vector<AreaScore> scores;
    std::string error;  ///< why there are none; empty where there are
};

/// Fits lobes to each source and draws it under comparedAreaLights().
std::vector<AreaScores> scoreAreaLights(const std::vector<std::string>& sources,
                                        const AreaBenchOptions& options, Progress& progress);

std::string areaText(const std::vector<AreaScores>& materials);
Json areaJson(const std::vector<AreaScores>& materials);

}  // namespace fbrdf::tool

// EnvironmentBench.h - how well lobes stand for materials under environments, beside the split sum.
#pragma once
#include "Errors.h"
#include "Progress.h"

#include <fbrdf/environment/Panorama.h>
#include <fbrdf/sources/OpenSource.h>

#include <string>
#include <vector>

namespace fbrdf::tool {

struct EnvironmentBenchOptions {
    std::vector<int> lobes{1, 2, 3};  ///< tilted ones; of anisotropic sources 1, 3 and 7 normals
    int size = 64;                    ///< pixels across the sphere
    int threads = 0;
    SourceOptions source;
};

/// One way of drawing one material.
struct EnvironmentScore {
    std::string label;         ///< "split sum", "K = 2"
    std::vector<double> psnr;  ///< of each environment, dB
    size_t bytes = 0;          ///< of the table, its numbers as half floats
    double seconds = 0.0;      ///< of the fit
    double mean() const;
    double worst() const;
};

struct EnvironmentScores {
    std::string source;
    std::vector<EnvironmentScore> scores;  ///< the split sum first
    std::string error;                     ///< why there are none; empty where there are
};

struct NamedPanorama {
    std::string name;
    Panorama panorama;
    std::string note;  ///< what its file was taken for, and what was repaired; may be empty
};

/// Every .exr and .hdr of a folder, in the order of their names. Throws Error(input) where there is
/// none, or one cannot be read.
std::vector<NamedPanorama> environmentsOf(const std::string& folder);

std::vector<EnvironmentScores> scoreEnvironments(const std::vector<std::string>& sources,
                                                 const std::vector<NamedPanorama>& environments,
                                                 const EnvironmentBenchOptions& options,
                                                 Progress& progress);

std::string environmentText(const std::vector<EnvironmentScores>& materials,
                            const std::vector<NamedPanorama>& environments);
Json environmentJson(const std::vector<EnvironmentScores>& materials,
                     const std::vector<NamedPanorama>& environments);

}  // namespace fbrdf::tool

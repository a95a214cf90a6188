// BenchSummary.h - the scores of many materials as one table: means, tenth percentile, worst, and
// in how many materials the best of our forms is ahead of every peer.
#pragma once
#include "bench/BenchFit.h"

#include <string>
#include <vector>

namespace fbrdf::tool {

/// One error of one contender over the materials that have it.
struct ErrorSpread {
    double mean = 0;
    double tenth = 0;  ///< a tenth of the materials are as bad or worse
    double worst = 0;
    std::string worstMaterial;
};

struct ContenderSummary {
    Contender contender;
    size_t materials = 0;
    double bytes = 0, lookups = 0, seconds = 0;  ///< means
    std::map<std::string, ErrorSpread> errors;
    double belowOneItp = 0;  ///< share of the materials with a delta_e_itp below 1
};

/// Compares by psnr_linear where there is a picture, else by log_median.
struct AheadOfPeers {
    size_t ahead = 0, of = 0;         ///< materials; those without a peer do not count
    std::vector<std::string> behind;  ///< "grease-covered-steel (npf 41.2, ours 40.1)"
};

/// True for errors of which larger is better.
bool largerIsBetter(const std::string& error);

std::vector<ContenderSummary> summarise(const std::vector<MaterialScores>& materials);
AheadOfPeers aheadOfPeers(const std::vector<MaterialScores>& materials);

std::string benchText(const std::vector<MaterialScores>& materials);
Json benchJson(const std::vector<MaterialScores>& materials);

}  // namespace fbrdf::tool

// BenchCsv.h - scores as a file that a long run writes after every material and that a later run
// goes on from.
#pragma once
#include "bench/BenchFit.h"

#include <string>
#include <vector>

namespace fbrdf::tool {

/// A row for each material and contender; empty numbers where the contender has no answer.
std::string benchCsv(const std::vector<MaterialScores>& materials,
                     const std::vector<Contender>& contenders);

/// Reads the materials of such a file that have a row for every contender. Throws Error(input)
/// naming `path` for a file with other columns.
std::vector<MaterialScores> scoresFromCsv(const std::string& path,
                                          const std::vector<Contender>& contenders);

}  // namespace fbrdf::tool

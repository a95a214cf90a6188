// EnvironmentCost.h - what light from everywhere and area lights cost a frame, against GGX under
// the same environment by the split sum.
#pragma once
#include "bench/Options.h"

#include <string>
#include <vector>

namespace fbrdf::bench {

struct EnvironmentRow {
    std::string name;
    double milliseconds = 0.0;  ///< median over the frames
    double ratio = 0.0;         ///< to the split sum in the same turns
    int passes = 0;             ///< 0: of the peer
    int lookups = 0;            ///< of a fragment in any pass
};

struct EnvironmentMeasurement {
    std::string glRenderer, glVersion, mesh;
    int width = 0, height = 0;
    Options::Clock clock = Options::Clock::wall;
    std::vector<EnvironmentRow> rows;
};

/// One for each mesh of the options. Throws Error(gl) where there is no usable GL.
std::vector<EnvironmentMeasurement> measureEnvironment(const Options& options);

std::string asText(const std::vector<EnvironmentMeasurement>& measurements);
std::string asJson(const std::vector<EnvironmentMeasurement>& measurements);

}  // namespace fbrdf::bench

// Measure.h - times variants in turn: one frame of each, then the next frame of each, so that
// other load of the machine affects all alike.
#pragma once
#include "bench/Options.h"
#include "bench/Variants.h"

#include <fbrdf/headless/Context.h>

#include <string>
#include <vector>

namespace fbrdf::bench {

/// One variant with one number of lights on one mesh.
struct Timing {
    std::string variant;
    double milliseconds = 0.0;  ///< median over the frames
    double ratio = 0.0;  ///< time relative to `ggx` in the same turns; 0 where that was left out
    int frames = 0;
    LightCost cost = {};
};

struct LeftOut {
    std::string variant, reason;
};

struct Table {
    std::string mesh;
    int lights = 0;
    std::vector<Timing> timings;
    std::vector<LeftOut> leftOut;
};

struct Measurement {
    std::string glRenderer, glVersion;
    int width = 0, height = 0;
    Options::Clock clock = Options::Clock::wall;
    std::vector<Table> tables;
};

/// Throws Error(gl) where there is no usable GL, Error(usage) for an unknown variant.
Measurement measure(const Options& options);

}  // namespace fbrdf::bench

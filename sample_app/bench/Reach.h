// Reach.h - the cost of a frame with thousands of lights that have a radius, by how many of them
// reach a pixel, compared with a single list of that many lights.
#pragma once
#include "bench/Options.h"

#include <string>
#include <vector>

namespace fbrdf::bench {

constexpr int kReachLights = 4096;

struct ReachRow {
    int wanted = 0;          ///< lights that should reach a pixel
    double reaching = 0.0;   ///< lights that reach it, on average
    double listed = 0.0;     ///< lights in the list of a pixel, on average
    double clustered = 0.0;  ///< ms a frame with all lights, clustered
    double building = 0.0;   ///< ms of that on the CPU, for the lists
    double oneList = 0.0;    ///< ms a frame with `wanted` lights that reach every pixel
};

struct ReachMeasurement {
    std::string glRenderer, glVersion;
    int width = 0, height = 0;
    Options::Clock clock = Options::Clock::wall;
    std::vector<ReachRow> rows;
};

/// One row for each of options.lights, on the full-screen triangle. Throws Error(gl) where there is
/// no GL with lists of lights.
ReachMeasurement measureReach(const Options& options);

std::string asText(const ReachMeasurement& measurement);
std::string asJson(const ReachMeasurement& measurement);

}  // namespace fbrdf::bench

// Reach.h - the cost of a frame with thousands of lights that have a radius, by how many of them
// reach a pixel, compared with a single list of that many lights.
#pragma once
#include "bench/Options.h"

#include <string>
#include <vector>

namespace fbrdf::bench {

constexpr int kReachLights = 4096, kMovingLights = 40, kCulledLights = 100000;

struct ReachRow {
    int wanted = 0;          ///< lights that should reach a pixel
    double reaching = 0.0;   ///< lights that reach it, on average
    double listed = 0.0;     ///< lights in the list of a pixel, on average
    double clustered = 0.0;  ///< ms a frame with all lights, in lists of the CPU that are made anew
    double building = 0.0;   ///< ms of that for the lists
    double editing = 0.0;    ///< ms for the lists where kMovingLights have moved
    double spots = 0.0;      ///< ms to make the lists anew where all lights are spots
    double byGpu = 0.0;      ///< ms a frame with lists of the GPU; 0: it cannot make them
    double oneList = 0.0;    ///< ms a frame with `wanted` lights that reach every pixel
};

/// Lists of the lights that are seen, of many more.
struct CulledRow {
    size_t given = 0, seen = 0;
    double building = 0.0;  ///< ms to find them and make their lists
};

struct ReachMeasurement {
    std::string glRenderer, glVersion;
    int width = 0, height = 0;
    Options::Clock clock = Options::Clock::wall;
    std::vector<ReachRow> rows;
    CulledRow culled;
    std::string whyNotByGpu;  ///< "" where byGpu was measured
};

/// One row for each of options.lights, on the full-screen triangle. Throws Error(gl) where there is
/// no GL with lists of lights.
ReachMeasurement measureReach(const Options& options);

std::string asText(const ReachMeasurement& measurement);
std::string asJson(const ReachMeasurement& measurement);

}  // namespace fbrdf::bench

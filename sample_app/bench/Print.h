// Print.h - prints a measurement as text or as JSON.
#pragma once
#include "bench/Measure.h"

namespace fbrdf::bench {

const char* clockName(Options::Clock clock);  ///< "cpu", "wall"

/// A table for each mesh, with a row for each variant: what it costs (LightCost) with the most
/// lights and, for each number of lights, milliseconds and ratio.
std::string asText(const Measurement& measurement);

/// {"renderer", "version", "size": [w, h], "clock", "results": [{"mesh", "lights", "variant",
/// "milliseconds", "ratio", "frames", "multiply_adds", "specials", "bytes"}], "left_out": [{"mesh",
/// "lights", "variant", "reason"}]}. ratio is null where `ggx` was not timed.
std::string asJson(const Measurement& measurement);

}  // namespace fbrdf::bench

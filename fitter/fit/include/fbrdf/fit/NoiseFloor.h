// NoiseFloor.h - the level below which values of a measurement say nothing, estimated from the
// measurement.
#pragma once
#include <fbrdf/sources/Source.h>

namespace fbrdf {

/// Sigma of the noise per channel, in 1/sr; 0 for data without a trace of noise. Negative values
/// are noise seen from its other side: their rms is sigma. Where noise was clipped to exact zeros,
/// as many positive values are noise again as zeros were found (noise is symmetric about 0): sigma
/// follows from the median of those.
Vec3f estimateNoiseFloor(const std::vector<Sample>& samples);

}  // namespace fbrdf

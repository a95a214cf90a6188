// NoiseFloor.h - the level below which values of a measurement say nothing, estimated from the
// measurement.
#pragma once
#include <fbrdf/sources/Source.h>

namespace fbrdf {

/// Per channel, in 1/sr; 0 for data without a trace of noise. Negative values are noise seen from
/// its other side: their rms is the floor. Where noise was clipped to exact zeros, as many positive
/// values must lie below the floor again as zeros were found (noise is symmetric about 0): the
/// floor is that quantile of the positive values.
Vec3f estimateNoiseFloor(const std::vector<Sample>& samples);

}  // namespace fbrdf

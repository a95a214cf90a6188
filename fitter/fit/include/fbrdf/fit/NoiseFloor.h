// NoiseFloor.h - the level below which the values of a measurement are noise, estimated from the
// measurement itself.
#pragma once
#include <fbrdf/sources/Source.h>

namespace fbrdf {

/// The noise that is added to the values of a measurement.
struct NoiseModel {
    Vec3f sigma{0.0f};        ///< per channel, in 1/sr; 0 for data without a trace of noise
    bool overCosine = false;  ///< sigma is that of f cos theta_i: of radiance, and not of f
    bool unclipped = false;   ///< there are negative values: the noise is seen whole
};

/// Negative values are noise seen from its other side: the median of their magnitudes gives sigma.
/// Whether they belong to f or to f cos theta_i is decided by the likelihood of half normals. Where
/// noise was clipped to exact zeros, as many positive values are noise again as zeros were found
/// (noise is symmetric about 0): sigma follows from the median of those. Negative values whose
/// neighbours are negative as well are colours outside the gamut of the primaries, and no noise:
/// sigma then follows from what neighbours differ by, or is 0.004 of the median of the brightest
/// channel if that is more.
NoiseModel estimateNoise(const std::vector<Sample>& samples);

/// The sigma of estimateNoise as a level of f; with overCosine it is the level at normal incidence.
Vec3f estimateNoiseFloor(const std::vector<Sample>& samples);

}  // namespace fbrdf

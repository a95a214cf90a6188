// Misfit.h - where a form does not follow the data, and where there are no data: a small mean error
// can hide both.
//
// Residuals are ln g / f. Noise differs from sample to sample; neighbours share what the form
// cannot represent. The structural part of a region's residuals is therefore the mean product of
// those of distinct samples in one small cell of directions (a nugget-free variogram; Matheron
// 1963).
#pragma once
#include <fbrdf/sources/Source.h>

#include <array>
#include <string>
#include <vector>

namespace fbrdf {

/// A range of half and difference angles in which the fit is wrong by more than noise. theta_d is
/// half the angle between light and view: below kRetroAngle light comes back where it came from.
struct MisfitRegion {
    double theta_hFrom = 0, theta_hTo = 0, theta_dFrom = 0, theta_dTo = 0;  ///< degrees
    std::array<bool, 3> channels{};  ///< R, G, B that are wrong
    size_t samples = 0;              ///< above the noise there
    double light = 0;   ///< share of all reflected light, c f, that these channels have there
    double factor = 1;  ///< e to the structural rms, the worst channel's: how far off, as a ratio
    double bias = 1;    ///< geometric mean of g / f there, that channel's: below 1 is too dark
};
constexpr double kRetroAngle = 5.0;  ///< degrees

/// "theta_h 25 to 50, theta_d 0 to 5 degrees (back towards the light), R: off by a factor of 3, too
/// dark": one line.
std::string describe(const MisfitRegion& region);

/// Regions in which the form does not follow the data, the one with most light first; empty where
/// it follows them everywhere. `exact`: the values are those of a function, and every residual is
/// structural. A channel at or below the floor takes no part. Precondition: as many values as
/// samples. `threads`: 0 for one a core.
std::vector<MisfitRegion> misfitRegions(const std::vector<Sample>& samples,
                                        const std::vector<Vec3f>& fitted, const Vec3f& noiseFloor,
                                        bool exact, int threads = 0);

/// The directions that the data have.
struct Coverage {
    bool inPlane = false;     ///< wo in the plane of incidence, for all samples but a few
    bool oneAzimuth = false;  ///< light from one azimuth alone: anisotropy cannot show
    double theta_iFrom = 0, theta_iTo = 0;  ///< degrees
    size_t incidences = 0;                  ///< distinct theta_i, to the degree
};
Coverage coverageOf(const std::vector<Sample>& samples);

/// "light from 5 to 75 degrees, view in the plane of incidence only: ...": one line.
std::string describe(const Coverage& coverage);

}  // namespace fbrdf

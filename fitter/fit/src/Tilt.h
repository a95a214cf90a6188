// Tilt.h - samples of a surface that did not lie straight in its holder.
//
// Where the normal of a surface is half a degree off, the mirror direction is a degree off: a
// narrow highlight is many times too dark on one side of the plane of incidence and too bright on
// the other. No isotropic surface does that, and no isotropic form can follow it.
#pragma once
#include "data/DataStatistics.h"

#include <fbrdf/fit/Fit.h>

#include <optional>
#include <vector>

namespace fbrdf {

/// The tilt under which an isotropic form follows the samples much better than as they are, or
/// nothing. Only samples on both sides of the plane of incidence show it; some thousand are enough.
/// Where light comes from one azimuth, the component along it is found in part: the form follows
/// what that does to a highlight as it follows shadowing.
std::optional<Tilt> tiltOf(const std::vector<Sample>& samples, const DataStatistics& statistics,
                           const FitOptions& options);

/// The sample in the frame of the surface's own normal, about which the shortest turn leads there.
Sample straightened(Sample sample, const Tilt& tilt);

/// The samples in that frame; those that are below the surface's horizon are left out, and those so
/// near it that a cosine is twice or half of what it was.
std::vector<Sample> straightened(const std::vector<Sample>& samples, const Tilt& tilt);

}  // namespace fbrdf

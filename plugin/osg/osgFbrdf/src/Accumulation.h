// Accumulation.h - in which format passes add up, and what the error of that depends on.
#pragma once
#include "Illumination.h"

#include <fbrdf/plan/Plan.h>

#include <array>
#include <optional>

namespace osgFbrdf {

class FactorizedBrdf;

/// The formats of surfaces in the order in which they are tried: the one that is wanted, finer ones
/// where its error is too large, coarser ones where there are no others.
std::array<fbrdf::ColourFormat, 3> formatsFrom(fbrdf::ColourFormat wanted);

/// Of the material, exposed, and of the lights; none where attenuation.glsl may raise them, or
/// where lists have them.
std::optional<fbrdf::Peaks> peaksOf(const FactorizedBrdf& effect, const Illumination& light);

}  // namespace osgFbrdf

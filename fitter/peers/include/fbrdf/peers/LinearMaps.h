// LinearMaps.h - a one-term material as linear 8-bit maps, the storage of McCool, Ang, Ahmad 2001.
//
// A linear map stores F / scale in [0, 1] in steps of 1/255. A map scaled by its largest texel, at
// the horizon as a rule, leaves a few steps for all others; scaled by less, it clips. The scale of
// each map is the quantile of its texels whose product with the others has the least error.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <functional>

namespace fbrdf {

using MaterialError = std::function<double(const Material& material)>;

/// The material with linear8 tables. Throws Error(usage) unless it has one term.
Material linearMaps(const Material& material, const MaterialError& errorOf);

}  // namespace fbrdf

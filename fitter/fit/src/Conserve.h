// Conserve.h - energy conservation: a directional albedo of at most 1.
#pragma once
#include <fbrdf/brdf/Material.h>

namespace fbrdf {

/// The largest directional albedo of any channel, computed every 2 degrees to 88 from the normal,
/// in 4 azimuths for forms that are not isotropic.
double largestAlbedo(const Material& material, int threads);

/// Scales the terms of the material down, all channels alike so that hues stay, until no
/// directional albedo exceeds 1; returns the factor, 1 where nothing had to be done.
double conserveEnergy(Material& material, int threads);

}  // namespace fbrdf

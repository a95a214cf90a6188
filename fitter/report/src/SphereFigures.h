// SphereFigures.h - the standard sphere as data, fit, their amplified difference, and what of it is
// invented.
#pragma once
#include "Invented.h"
#include "Picture.h"

#include <fbrdf/metrics/StandardSphere.h>

#include <string>

namespace fbrdf {

/// sRGB of the radiance; transparent where nothing is covered.
Picture pictureOf(const SphereImage& image);

/// 1/2 + amplification (fit - data) as display values: mid-grey where they agree, brighter where
/// the fit is.
Picture differencePicture(const SphereImage& fit, const SphereImage& data, double amplification);

/// The largest of 1, 2, 5, 10, 20, ... 1000 at which 99 % of the covered pixels' channels stay in
/// range.
double amplificationFor(const SphereImage& fit, const SphereImage& data);

/// The fit as grey, and magenta by the share of a pixel's light that no sample supports.
Picture inventedPicture(const SphereImage& fit, const InventedSphere& invented);

/// Figures of the data, the fit, their difference (without data, when `data` has size 0, the fit
/// alone) and what is invented, unless that is null.
std::string sphereFigures(const SphereImage& data, const SphereImage& fit,
                          const InventedSphere* invented);

}  // namespace fbrdf

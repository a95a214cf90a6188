// SphereFigures.h - the standard sphere as data, fit and their amplified difference.
#pragma once
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

/// Three figures, or the fit alone when `data` has size 0.
std::string sphereFigures(const SphereImage& data, const SphereImage& fit);

}  // namespace fbrdf

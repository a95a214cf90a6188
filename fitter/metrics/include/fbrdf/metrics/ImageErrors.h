// ImageErrors.h - how far two pictures are from each other, as people see them.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <vector>

namespace fbrdf {

/// A picture as a screen shows it.
struct ShownImage {
    int width = 0, height = 0;
    std::vector<Vec3f> radiance;  ///< height x width; exposed, linear, in [0, 1]
    std::vector<bool> covered;    ///< height x width; the other pixels do not count
};

/// Differences of two pictures, over the covered pixels of the first.
struct ImageErrors {
    double psnrLinear = 0;  ///< dB, peak 1; infinite for pictures that are equal
    double psnrSrgb = 0;    ///< dB, peak 1, of sRGB-encoded values
    /// Wang et al. 2004 on sRGB luma, 11 x 11 Gaussian of 1.5, mean over covered pixels.
    double ssim = 0;
    /// ITU-R BT.2124: 720 sqrt(dI^2 + (dT/2)^2 + dP^2), mean; white at 203 cd/m2 (BT.2408).
    double deltaEItp = 0;
    double flip = 0;  ///< Andersson et al. 2020 (LDR), 67 pixels a degree, mean
};

/// Precondition: both have one size. Not a number where no pixel is covered.
ImageErrors imageErrors(const ShownImage& image, const ShownImage& reference);

}  // namespace fbrdf

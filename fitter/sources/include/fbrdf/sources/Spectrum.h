// Spectrum.h - from a reflectance spectrum to linear sRGB (Rec. 709 primaries, white D65).
// Under illuminant D65 with the CIE 1931 2 degree observer a spectrum that is 1 everywhere has the
// colour of the white point, so it becomes (1, 1, 1) without an adaptation step; any other
// illuminant would need one. Colour values: CIE 15:2004 tables T.4 (observer) and T.1 (D65), every
// 10 nm from 380 to 780 nm; the matrix is that of IEC 61966-2-1.
// Colours outside the gamut come out with a channel below 0 and are left so.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <vector>

namespace fbrdf {

/// Linear sRGB of a colour in CIE XYZ whose white is D65 with Y = 1.
Vec3d linearSrgbFromXyz(const Vec3d& xyz);

/// Weights that turn spectra sampled at fixed wavelengths into linear sRGB.
class SpectrumToRgb {
public:
    /// `wavelengths` - n, nm, strictly ascending, n >= 1. Between them a spectrum is linear,
    /// outside them constant. Throws Error(input) when they do not ascend or are not positive.
    explicit SpectrumToRgb(const std::vector<double>& wavelengths);

    size_t size() const { return weights_.size(); }
    /// `spectrum` - size() values. The weights of each channel sum to 1.
    Vec3d operator()(const double* spectrum) const;

private:
    std::vector<Vec3d> weights_;
};

}  // namespace fbrdf

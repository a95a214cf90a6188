// Tristimulus.h - CIE XYZ of either white in use, to linear sRGB.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <string>
#include <vector>

namespace fbrdf {

/// What X, Y and Z of a grey surface are: those of D65 (0.9505, 1, 1.0890), or equal.
enum class XyzWhite { d65, equalEnergy };

/// Linear sRGB of XYZ under a white. That of equal energy is adapted to D65 by Bradford's matrix
/// (Lam 1985; ICC.1:2010, annex E), so that grey stays grey.
Vec3d linearSrgbFromXyz(const Vec3d& xyz, XyzWhite white);

/// Linear sRGB of XYZ whose white has the chromaticity (x, y) of CIE 1931, adapted to D65 likewise.
Vec3d linearSrgbFromXyz(const Vec3d& xyz, double whiteX, double whiteY);

/// "white of X, Y, Z is D65", and by what it was told: for Source::assumptions.
std::string describeWhite(XyzWhite white);

/// The white of a data set that Radiance's tools may have written: "d65" or "e" as it was chosen,
/// or, where `chosen` is empty, that which the sums of X, Y and Z over the data suggest, which is
/// added to `assumptions`.
XyzWhite whiteOfXyz(const std::string& chosen, const Vec3d& sums,
                    std::vector<std::string>& assumptions);

/// Whether sums of X, Y and Z over a data set have the proportions of grey under D65, within 2 %.
bool isGreyUnderD65(const Vec3d& sums);

}  // namespace fbrdf

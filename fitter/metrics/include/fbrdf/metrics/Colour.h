// Colour.h - the colour spaces that pictures are compared in. See Srgb.h for the curve of sRGB.
// Linear RGB has the Rec. 709 primaries and white 1 (Conventions.h).
#pragma once
#include <fbrdf/brdf/Conventions.h>

namespace fbrdf {

/// PQ, the inverse EOTF of ITU-R BT.2100 Table 4: luminance in cd/m2 (0 .. 10,000) to [0, 1].
double pqFromLuminance(double luminance);

/// (I, T, P) of ITU-R BT.2124 Annex 1, from linear Rec. 709 RGB >= 0: BT.2020 primaries (BT.2087),
/// LMS, PQ, T halved. RGB 1 stands for 203 cd/m2, the reference white of BT.2408.
Vec3d itpFromLinear(const Vec3d& rgb);

/// Delta E ITP (BT.2124): 720 |a - b|; 1 is a just noticeable difference under the most critical
/// adaptation.
double deltaEItp(const Vec3d& itpA, const Vec3d& itpB);

}  // namespace fbrdf

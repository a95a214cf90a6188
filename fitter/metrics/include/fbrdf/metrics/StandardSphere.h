// StandardSphere.h - the fixed scene in which materials are compared as pictures.
//
// A sphere filling a square image, orthographic along -z, tangent along increasing azimuth about
// +y, lit by 6 directional lights and a sky of 122; pairs with an elevation below half a degree add
// nothing. The exposure is such that a Lambertian of albedo 1/2 averages 0.4. Only numbers from
// this scene compare with each other.
#pragma once
#include <fbrdf/metrics/ImageErrors.h>
#include <fbrdf/sources/Source.h>

#include <vector>

namespace fbrdf {

struct SphereImage {
    int size = 0;  ///< pixels on a side; row 0 is the top (y = +1)
    /// size x size, exposed, linear, clamped to [0, 1]; 0 outside the disc.
    std::vector<Vec3f> radiance;
    std::vector<bool> covered;  ///< size x size
};

/// Precondition: size > 0.
SphereImage renderStandardSphere(const BrdfFunction& brdf, int size = 256, int threads = 0);

/// What one light adds to one pixel of the standard sphere: f(pair) times `weight`.
struct SphereTerm {
    int pixel = 0;  ///< in SphereImage::radiance
    DirectionPair<double> pair;
    Vec3d weight;  ///< irradiance, cosine and exposure
};

/// The terms of every pixel, in the order of pixels; their sums, clamped to [0, 1], are the
/// picture. Precondition: size > 0.
std::vector<SphereTerm> standardSphereTerms(int size);

/// Differences of two pictures of the standard sphere, over its disc.
/// Precondition: both have one size.
ImageErrors imageErrors(const SphereImage& image, const SphereImage& reference);

}  // namespace fbrdf

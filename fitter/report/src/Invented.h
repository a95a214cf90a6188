// Invented.h - what of a material no sample supports, as a share of what it shows.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/metrics/StandardSphere.h>

#include <vector>

namespace fbrdf {

/// True where a table has texels that no sample of the fit supports (Table::unsupported).
bool hasInvented(const Material& material);

/// Share of f(wo, wi) that such texels decide, in [0, 1]: of a product 1 minus the product over its
/// look-ups of the interpolation weights of supported texels, of a sum the mean over its terms by
/// their magnitudes. 0 where f is 0. Directions as for evaluate().
double inventedShare(const Material& material, const Vec3d& wo, const Vec3d& wi);

/// The standard sphere by that share.
struct InventedSphere {
    std::vector<double> shares;  ///< of the radiance of every pixel, as SphereImage::radiance
    double total = 0;            ///< of the radiance of all pixels
};
InventedSphere inventedSphere(const Material& material, int size);

}  // namespace fbrdf

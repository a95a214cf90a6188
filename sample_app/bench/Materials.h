// Materials.h - one material in every form that is measured: isotropic GGX, written down and not
// fitted, because GGX is a product of D(theta_h), F(theta_d) and V(theta_i, theta_o) already. A
// form that lacks one of these angles lacks that factor: the values of texels do not change the
// cost of a fetch.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <string>
#include <vector>

namespace fbrdf::bench {

/// The parameters that every GGX of the benchmark has.
constexpr double kAlpha = 0.3, kAlphaAcross = 0.15;
const Vec3d kF0(0.9, 0.6, 0.3), kDiffuse(0.1, 0.2, 0.3);

/// Every form that `fbrdf fit` knows by name, sums of two products, singular values with 2, 4 and 8
/// terms, and the factors that models write down.
std::vector<std::string> allForms();

/// form: a name of makeForm; the first term of a sum is the Lambertian part. "svdN": N terms by
/// singular values. "analytic:ward", "analytic:ashikhmin-shirley": those models instead of GGX.
/// Throws Error(usage) for other names.
Material benchMaterial(const std::string& form);

}  // namespace fbrdf::bench

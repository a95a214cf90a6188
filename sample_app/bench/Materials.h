// Materials.h - one material in every form that is timed: isotropic GGX, written down and not
// fitted, because GGX is a product of D(theta_h), F(theta_d) and V(theta_i, theta_o) already. The
// values of texels do not change the cost of a fetch.
#pragma once
#include <fbrdf/brdf/Material.h>

namespace fbrdf::bench {

/// The parameters that every GGX of the benchmark has.
constexpr double kAlpha = 0.3, kAlphaAcross = 0.15;
const Vec3d kF0(0.9, 0.6, 0.3), kDiffuse(0.1, 0.2, 0.3);

/// form: "hdio", "pqp", "pqpr", or "io+hdio", whose first term is the Lambertian part.
Material ggxMaterial(const std::string& form);

}  // namespace fbrdf::bench

// AnalyticFactors.h - materials whose factors are written down from a model's own structure,
// without a fit (the analytic factorizations of McCool 2002).
//
//   Ward 1992:              f = kd / pi + p(wo) q(h) p(wi),   p = cos^-1/2,
//                           q = ks exp(-tan^2 theta_h (..)) / (4 pi ax ay)
//   Ashikhmin-Shirley 2000: f = d(wo) d(wi) + q(h) r(theta_d) T(theta_i, theta_o),
//                           d = 1 - (1 - cos / 2)^5, T = 1 / max(cos_i, cos_o), r = F / cos
//                           theta_d, q = cos theta_h^(nu cos^2 phi_h + nv sin^2 phi_h) (..)
// p, d and r depend on one angle and are uniform arrays: Ward costs one look-up, Ashikhmin-Shirley
// two. Both are exact at the centres of texels and knots; what is lost is lost between them.
#pragma once
#include <fbrdf/brdf/Material.h>

#include <optional>
#include <string>

namespace fbrdf {

/// True for a specification of one of these models or of a preset of them.
bool hasAnalyticFactors(const std::string& spec);

/// The material of a specification "ward:..." or "ashikhmin-shirley:..." (or a preset of them);
/// nothing for other models. `size`: texels on a side of q, >= 2. `storage`: one of logarithms
/// (isLog). Throws as parseModelSpec.
std::optional<Material> analyticFactors(const std::string& spec, int size, Storage storage);

}  // namespace fbrdf

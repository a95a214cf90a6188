// Ashikhmin and Shirley's anisotropic Phong lobe with Fresnel and the coupled diffuse part.
#include "Microfacet.h"

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

struct Exponents {
    double u, v;
};

/// (n.h)^((nu hx^2 + nv hy^2) / (1 - hz^2)). Both the power and the quotient are 0 / 0 or 1^inf at
/// the pole; log cos = log1p(-sin^2) / 2 keeps the digits there.
double lobe(const HalfGeometry& half, const Exponents& n)
{
    const double s = half.sineSquared_h;
    if (s <= 0.0) return 1.0;
    const double weighted = n.u * half.h.x * half.h.x + n.v * half.h.y * half.h.y;
    const double logCosine = s < 0.5 ? 0.5 * std::log1p(-s) : std::log(half.h.z);
    return std::exp(weighted / s * logCosine);
}

/// 1 - (1 - cosine / 2)^5
double diffuseShape(double cosine)
{
    const double x = 1.0 - 0.5 * cosine;
    return 1.0 - x * x * x * x * x;
}

BrdfFunction make(const ModelValues& values)
{
    const Exponents n{scalarOf(values, "nu"), scalarOf(values, "nv")};
    const Vec3d ks = colourOf(values, "ks");
    const double normalisation = std::sqrt((n.u + 1.0) * (n.v + 1.0)) / (8.0 * kPi);
    const Vec3d diffuse = colourOf(values, "kd") * (Vec3d(1.0) - ks) * (28.0 / (23.0 * kPi));
    return [=](const Vec3d& wo, const Vec3d& wi) {
        const HalfGeometry half(wo, wi);
        // Ashikhmin and Shirley 2000, section 2: the specular lobe over (h.k) max(n.k1, n.k2) ...
        const double specular =
            normalisation * lobe(half, n) / (half.cosTheta_d * std::max(wo.z, wi.z));
        // ... and the diffuse part, which leaves what the lobe reflects.
        const double shape = diffuseShape(wo.z) * diffuseShape(wi.z);
        return diffuse * shape + schlickFresnel(ks, half.cosTheta_d) * specular;
    };
}

bool isotropic(const ModelValues& values)
{
    return scalarOf(values, "nu") == scalarOf(values, "nv");
}

}  // namespace

Model ashikhminShirleyModel()
{
    return {"ashikhmin-shirley",
            "Ashikhmin-Shirley, anisotropic Phong",
            "Ashikhmin and Shirley 2000, An Anisotropic Phong BRDF Model; with its coupled "
            "diffuse part",
            {albedoParameter("kd", 0.3, "albedo of the base below the lobe"),
             albedoParameter("ks", 0.05, "Fresnel reflectance at normal incidence"),
             scalarParameter("nu", 100.0, 0.0, 1e6, "exponent along the tangent"),
             scalarParameter("nv", 100.0, 0.0, 1e6, "exponent across the tangent")},
            isotropic,
            {"always", always},
            make};
}

}  // namespace fbrdf

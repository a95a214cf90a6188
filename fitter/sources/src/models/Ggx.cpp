// Microfacets with the GGX (Trowbridge-Reitz) distribution over a Lambertian.
#include "Microfacet.h"

namespace fbrdf {
namespace {

BrdfFunction make(const ModelValues& values)
{
    const Roughness alpha = roughnessOf(values);
    const Vec3d f0 = colourOf(values, "f0"), diffuse = colourOf(values, "kd") / kPi;
    return [=](const Vec3d& wo, const Vec3d& wi) {
        const HalfGeometry half(wo, wi);
        // Cook and Torrance 1982, with the 1 / (4 cos cos) of Walter et al. 2007, Eq. 20.
        const double reflection = correlatedReflection(
            ggxDistribution(half, alpha), ggxLambda(wo, alpha), ggxLambda(wi, alpha), wo, wi);
        return diffuse + schlickFresnel(f0, half.cosTheta_d) * reflection;
    };
}

}  // namespace

Model ggxModel()
{
    return {"ggx",
            "GGX microfacets and a Lambertian",
            "Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces; "
            "anisotropic, height-correlated masking of Heitz 2014; Schlick 1994 Fresnel",
            microfacetParameters(),
            roughnessIsIsotropic,
            {"kd = 0", hasNoDiffusePart},
            make};
}

}  // namespace fbrdf

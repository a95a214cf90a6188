// Microfacets with Beckmann's distribution (Gaussian slopes) over a Lambertian.
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
        const double reflection =
            correlatedReflection(beckmannDistribution(half, alpha), beckmannLambda(wo, alpha),
                                 beckmannLambda(wi, alpha), wo, wi);
        return diffuse + schlickFresnel(f0, half.cosTheta_d) * reflection;
    };
}

}  // namespace

Model beckmannModel()
{
    return {"beckmann",
            "Beckmann microfacets and a Lambertian",
            "Cook and Torrance 1982, A Reflectance Model for Computer Graphics; anisotropic, "
            "height-correlated masking of Heitz 2014 (exact Lambda); Schlick 1994 Fresnel",
            microfacetParameters(),
            roughnessIsIsotropic,
            {"kd = 0", hasNoDiffusePart},
            make};
}

}  // namespace fbrdf

// A rough diffuse base under a GGX interface.
#include "Microfacet.h"
#include "OrenNayar.h"

namespace fbrdf {
namespace {

BrdfFunction make(const ModelValues& values)
{
    const Vec3d albedo = colourOf(values, "albedo"), f0 = colourOf(values, "f0");
    const double sigma = scalarOf(values, "sigma"), alpha = scalarOf(values, "alpha");
    return [=](const Vec3d& wo, const Vec3d& wi) {
        const HalfGeometry half(wo, wi);
        const Roughness rough{alpha, alpha};
        const double reflection = correlatedReflection(
            ggxDistribution(half, rough), ggxLambda(wo, rough), ggxLambda(wi, rough), wo, wi);
        // The base gets what the interface lets in and returns what it lets out, once each way;
        // light that the interface sends back into the base is not followed.
        const Vec3d entering = Vec3d(1.0) - schlickFresnel(f0, wi.z);
        const Vec3d leaving = Vec3d(1.0) - schlickFresnel(f0, wo.z);
        return entering * leaving * orenNayar(albedo, sigma, wo, wi) +
               schlickFresnel(f0, half.cosTheta_d) * reflection;
    };
}

}  // namespace

Model plasticModel()
{
    return {"plastic",
            "GGX over an Oren-Nayar base",
            "Oren and Nayar 1994 under Walter et al. 2007; the base is weighted with the Schlick "
            "transmission of both directions (as Shirley et al. 1997 couple theirs)",
            {albedoParameter("albedo", 0.4, "albedo of the base's facets"), orenNayarSigma(0.2),
             alphaParameter("alpha", 0.1, "roughness (slope) of the interface"),
             albedoParameter("f0", 0.04, "Fresnel reflectance at normal incidence")},
            always,
            {"always", always},
            make};
}

}  // namespace fbrdf

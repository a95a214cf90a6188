// Blinn's lobe about the half vector, normalised, over a Lambertian.
#include "Microfacet.h"
#include "PhongLobes.h"

#include <cmath>

namespace fbrdf {
namespace {

BrdfFunction make(const ModelValues& values)
{
    const double n = scalarOf(values, "n");
    const Vec3d diffuse = colourOf(values, "kd") / kPi;
    const Vec3d specular = colourOf(values, "ks") * blinnPhongNormalisation(n);
    return [=](const Vec3d& wo, const Vec3d& wi) {
        return diffuse + specular * std::pow(HalfGeometry(wo, wi).h.z, n);
    };
}

}  // namespace

Model blinnPhongModel()
{
    return {"blinn-phong",
            "Blinn-Phong, normalised",
            "Blinn 1977, Models of Light Reflection for Computer Synthesized Pictures; normalised "
            "exactly at normal incidence; the lobe is not divided by the cosine",
            phongParameters(),
            always,
            {"kd + ks <= 1", diffuseAndSpecularSumToOne},
            make};
}

}  // namespace fbrdf

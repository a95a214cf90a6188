// Phong's lobe about the mirror direction, normalised, over a Lambertian.
#include "PhongLobes.h"

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

BrdfFunction make(const ModelValues& values)
{
    const double n = scalarOf(values, "n");
    const Vec3d diffuse = colourOf(values, "kd") / kPi;
    const Vec3d specular = colourOf(values, "ks") * phongNormalisation(n);
    return [=](const Vec3d& wo, const Vec3d& wi) {
        const Vec3d mirror(-wi.x, -wi.y, wi.z);
        const double cosine = std::clamp(glm::dot(mirror, wo), 0.0, 1.0);
        return diffuse + specular * std::pow(cosine, n);
    };
}

}  // namespace

Model phongModel()
{
    return {"phong",
            "Phong, normalised",
            "Phong 1975, Illumination for Computer Generated Pictures; normalised after Lafortune "
            "and Willems 1994; the lobe is not divided by the cosine",
            phongParameters(),
            always,
            {"kd + ks <= 1", diffuseAndSpecularSumToOne},
            make};
}

}  // namespace fbrdf

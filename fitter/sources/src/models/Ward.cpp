// Ward's anisotropic Gaussian highlight over a Lambertian.
#include "Microfacet.h"

#include <cmath>

namespace fbrdf {
namespace {

BrdfFunction make(const ModelValues& values)
{
    const Roughness alpha = roughnessOf(values);
    const Vec3d diffuse = colourOf(values, "rho_d") / kPi;
    const Vec3d specular = colourOf(values, "rho_s") / (4.0 * kPi * alpha.x * alpha.y);
    return [=](const Vec3d& wo, const Vec3d& wi) {
        const Vec3d h = HalfGeometry(wo, wi).h;
        const double x = h.x / (alpha.x * h.z), y = h.y / (alpha.y * h.z);
        // Ward 1992, Eq. 5a, with tan^2 of the half angle exact instead of approximated (Eq. 5b).
        return diffuse + specular * (std::exp(-x * x - y * y) / std::sqrt(wi.z * wo.z));
    };
}

}  // namespace

Model wardModel()
{
    return {"ward",
            "Ward, isotropic and anisotropic",
            "Ward 1992, Measuring and Modeling Anisotropic Reflection; reflects more than it "
            "receives towards grazing angles, as published",
            withRoughness({albedoParameter("rho_d", 0.2, "albedo of the Lambertian part"),
                           albedoParameter("rho_s", 0.2, "albedo of the highlight, roughly")},
                          0.15),
            roughnessIsIsotropic,
            {"", never},
            make};
}

}  // namespace fbrdf

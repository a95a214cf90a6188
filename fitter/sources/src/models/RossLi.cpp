// Land surfaces: the kernels of MODIS' BRDF and albedo product.
#include "ModelBuild.h"

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

/// Ross-thick: leaves of a dense canopy (Wanner, Li and Strahler 1995; Lucht et al. 2000, Eq. 38).
double rossThick(const Vec3d& wo, const Vec3d& wi)
{
    const double sine = glm::length(glm::cross(wo, wi)), cosine = glm::dot(wo, wi);
    const double phase = std::atan2(sine, cosine);
    return ((0.5 * kPi - phase) * cosine + sine) / (wo.z + wi.z) - 0.25 * kPi;
}

/// Li-sparse, made reciprocal: crowns that cast shadows (Lucht et al. 2000, Eqs. 39 to 44). Of the
/// two constants of its crowns b/r is 1, which leaves the angles as they are, and h/b is 2.
double liSparse(const Vec3d& wo, const Vec3d& wi)
{
    constexpr double kHeightOfCrowns = 2.0;  // h/b
    const double sec_o = 1.0 / wo.z, sec_i = 1.0 / wi.z, both = sec_o + sec_i;
    const double distance = std::hypot(wo.x * sec_o - wi.x * sec_i, wo.y * sec_o - wi.y * sec_i);
    const double across = (wo.x * wi.y - wo.y * wi.x) * sec_o * sec_i;
    const double cos_t = std::min(1.0, kHeightOfCrowns * std::hypot(distance, across) / both);
    const double t = std::acos(cos_t);
    const double overlap = (t - std::sin(t) * cos_t) * both / kPi;
    return overlap - both + 0.5 * (1.0 + glm::dot(wo, wi)) * sec_o * sec_i;
}

BrdfFunction make(const ModelValues& values)
{
    const Vec3d isotropic = colourOf(values, "f_iso"), volume = colourOf(values, "f_vol"),
                geometry = colourOf(values, "f_geo");
    return [=](const Vec3d& wo, const Vec3d& wi) {
        const Vec3d factor = isotropic + volume * rossThick(wo, wi) + geometry * liSparse(wo, wi);
        return glm::max(factor, Vec3d(0.0)) / kPi;  // the sum falls below 0 towards grazing
    };
}

}  // namespace

Model rossLiModel()
{
    return {"ross-li",
            "Ross-thick and Li-sparse kernels, land surfaces",
            "Lucht, Schaaf and Strahler 2000, An Algorithm for the Retrieval of Albedo from Space "
            "Using Semiempirical BRDF Models; h/b = 2 and b/r = 1, as MODIS' product MCD43 has "
            "them; its reflectance factor divided by pi, and 0 where it is negative",
            {colourParameter("f_iso", 0.2, 0.0, 1.0, "weight of the isotropic kernel"),
             colourParameter("f_vol", 0.1, 0.0, 1.0, "weight of the Ross-thick kernel"),
             colourParameter("f_geo", 0.03, 0.0, 1.0, "weight of the Li-sparse kernel")},
            always,
            {"", never},
            make};
}

}  // namespace fbrdf

// Land surfaces: the semi-empirical model of Rahman, Pinty and Verstraete.
#include "ModelBuild.h"

#include <cmath>

namespace fbrdf {
namespace {

/// Distance of the tangents of two directions, which is 0 at the hot spot: the paper's G.
double distanceOfTangents(const Vec3d& wo, const Vec3d& wi)
{
    return std::hypot(wo.x / wo.z - wi.x / wi.z, wo.y / wo.z - wi.y / wi.z);
}

/// Henyey and Greenstein's function, of the angle of scattering, which is pi less
/// the angle between the two directions: the paper's F(g).
double henyeyGreenstein(double asymmetry, double cosPhase)
{
    const double square = asymmetry * asymmetry;
    const double base = 1.0 + square + 2.0 * asymmetry * cosPhase;
    return (1.0 - square) / (base * std::sqrt(base));
}

BrdfFunction make(const ModelValues& values)
{
    const Vec3d rho_0 = colourOf(values, "rho_0"), given = colourOf(values, "rho_c");
    const double k = scalarOf(values, "k"), asymmetry = scalarOf(values, "theta");
    const Vec3d rho_c(given.x < 0.0 ? rho_0.x : given.x, given.y < 0.0 ? rho_0.y : given.y,
                      given.z < 0.0 ? rho_0.z : given.z);
    return [=](const Vec3d& wo, const Vec3d& wi) {
        // The three factors of the reflectance factor, pi f: Minnaert's, F(g) and 1 + R(G).
        const double minnaert = std::pow(wo.z * wi.z * (wo.z + wi.z), k - 1.0);
        const double phase = henyeyGreenstein(asymmetry, glm::dot(wo, wi));
        const Vec3d hotSpot = 1.0 + (1.0 - rho_c) / (1.0 + distanceOfTangents(wo, wi));
        return rho_0 * hotSpot * (minnaert * phase / kPi);
    };
}

}  // namespace

Model rpvModel()
{
    return {"rpv",
            "Rahman-Pinty-Verstraete, land surfaces",
            "Rahman, Pinty and Verstraete 1993, Coupled Surface-Atmosphere Reflectance (CSAR) "
            "Model 2: Semiempirical Surface Model Usable With NOAA AVHRR Data; its reflectance "
            "factor divided by pi",
            {colourParameter("rho_0", 0.1, 0.0, 1.0, "level of the reflectance"),
             scalarParameter("k", 0.7, 0.0, 2.0, "bowl shape below 1, bell shape above"),
             scalarParameter("theta", -0.1, -0.95, 0.95,
                             "asymmetry; below 0 backward, above 0 forward"),
             colourParameter("rho_c", -1.0, -1.0, 1.0,
                             "of the hot spot, 1 for none; below 0 it is rho_0, as in the paper")},
            always,
            {"", never},
            make};
}

}  // namespace fbrdf

// Rough diffuse surfaces: V-cavities of Lambertian facets with Gaussian slopes.
#include "OrenNayar.h"

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

/// cos(phi_i - phi_o); 1 where an azimuth is undefined, which every use of it multiplies by 0.
double cosAzimuthDifference(const Vec3d& wo, const Vec3d& wi)
{
    const double radii = std::hypot(wo.x, wo.y) * std::hypot(wi.x, wi.y);
    return radii > 0.0 ? std::clamp((wo.x * wi.x + wo.y * wi.y) / radii, -1.0, 1.0) : 1.0;
}

struct Angles {
    double alpha, beta;  ///< the larger and the smaller zenith angle
    double cosPhi;
};

/// Direct illumination: Oren and Nayar 1994, the functional approximation with C1, C2, C3.
double directPart(const Angles& a, double sigmaSquared)
{
    const double c1 = 1.0 - 0.5 * sigmaSquared / (sigmaSquared + 0.33);
    const double ratio = sigmaSquared / (sigmaSquared + 0.09);
    const double beta = 2.0 * a.beta / kPi;
    const double retreat = a.cosPhi >= 0.0 ? 0.0 : beta * beta * beta;
    const double c2 = 0.45 * ratio * (std::sin(a.alpha) - retreat);
    const double product = 4.0 * a.alpha * a.beta / (kPi * kPi);
    const double c3 = 0.125 * ratio * product * product;
    return c1 + a.cosPhi * c2 * std::tan(a.beta) +
           (1.0 - std::abs(a.cosPhi)) * c3 * std::tan(0.5 * (a.alpha + a.beta));
}

/// Light that two facets of a cavity pass on, without the squared albedo.
double interreflection(const Angles& a, double sigmaSquared)
{
    const double beta = 2.0 * a.beta / kPi;
    return 0.17 * sigmaSquared / (sigmaSquared + 0.13) * (1.0 - a.cosPhi * beta * beta);
}

BrdfFunction make(const ModelValues& values)
{
    const Vec3d albedo = colourOf(values, "albedo");
    const double sigma = scalarOf(values, "sigma");
    return [=](const Vec3d& wo, const Vec3d& wi) { return orenNayar(albedo, sigma, wo, wi); };
}

// The published approximations let a white surface gain up to a few per cent; measured over sigma
// by the test of this model.
bool isDarkEnough(const ModelValues& values)
{
    const Vec3d albedo = colourOf(values, "albedo");
    return std::max({albedo.x, albedo.y, albedo.z}) <= 0.95;
}

}  // namespace

Vec3d orenNayar(const Vec3d& albedo, double sigma, const Vec3d& wo, const Vec3d& wi)
{
    const double theta_o = zenithAngle(wo), theta_i = zenithAngle(wi);
    const Angles a{std::max(theta_o, theta_i), std::min(theta_o, theta_i),
                   cosAzimuthDifference(wo, wi)};
    const double sigmaSquared = sigma * sigma;
    // The approximations are not positive by construction.
    const double direct = std::max(0.0, directPart(a, sigmaSquared));
    const double second = std::max(0.0, interreflection(a, sigmaSquared));
    return (albedo * direct + albedo * albedo * second) / kPi;
}

ModelParameter orenNayarSigma(double initial)
{
    return scalarParameter("sigma", initial, 0.0, 0.5 * kPi,
                           "standard deviation of the facets' slope, radians");
}

Model orenNayarModel()
{
    return {"oren-nayar",
            "Oren-Nayar, full model",
            "Oren and Nayar 1994, Generalization of Lambert's Reflectance Model; the full model "
            "(C1, C2, C3 and interreflection), not the qualitative one",
            {albedoParameter("albedo", 0.5, "albedo of the facets"), orenNayarSigma(0.35)},
            always,
            {"albedo <= 0.95", isDarkEnough},
            make};
}

}  // namespace fbrdf

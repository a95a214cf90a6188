#include "Microfacet.h"

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// Below this a highlight is a few nanosteradians wide and no table resolves it; above, the surface
// has no meaning as a height field.
constexpr double kRoughnessMin = 1e-4, kRoughnessMax = 2.0;

/// tan(theta) times the roughness projected on the direction's azimuth: Heitz 2014, section 5.3.
double projectedSlope(const Vec3d& w, const Roughness& alpha)
{
    return std::hypot(alpha.x * w.x, alpha.y * w.y) / w.z;
}

}  // namespace

HalfGeometry::HalfGeometry(const Vec3d& wo, const Vec3d& wi)
{
    const Vec3d sum = wo + wi;
    const double length = std::sqrt(glm::dot(sum, sum));
    h = sum / length;
    cosTheta_d = std::min(1.0, 0.5 * length);
    sineSquared_h = square(h.x) + square(h.y);
}

double schlickWeight(double cosine)
{
    const double complement = std::clamp(1.0 - cosine, 0.0, 1.0);
    return square(square(complement)) * complement;
}

Vec3d schlickFresnel(const Vec3d& f0, double cosine)
{
    return f0 + (Vec3d(1.0) - f0) * schlickWeight(cosine);
}

double ggxDistribution(const HalfGeometry& half, const Roughness& alpha)
{
    const Vec3d& h = half.h;
    // Heitz 2014, Eq. 85 (isotropic: Walter et al. 2007, Eq. 33), times cos^4 inside the square.
    const double sum = square(h.x / alpha.x) + square(h.y / alpha.y) + square(h.z);
    return 1.0 / (kPi * alpha.x * alpha.y * square(sum));
}

double beckmannDistribution(const HalfGeometry& half, const Roughness& alpha)
{
    const Vec3d& h = half.h;
    const double cosineSquared = square(h.z);
    // Heitz 2014, section 5.4 (isotropic: Walter et al. 2007, Eq. 25).
    const double exponent = (square(h.x / alpha.x) + square(h.y / alpha.y)) / cosineSquared;
    return std::exp(-exponent) / (kPi * alpha.x * alpha.y * square(cosineSquared));
}

double ggxLambda(const Vec3d& w, const Roughness& alpha)
{
    const double slopeSquared = square(projectedSlope(w, alpha));
    // Heitz 2014, Eq. 72: (sqrt(1 + s^2) - 1) / 2, written without its cancellation at s = 0.
    return 0.5 * slopeSquared / (1.0 + std::sqrt(1.0 + slopeSquared));
}

double beckmannLambda(const Vec3d& w, const Roughness& alpha)
{
    const double slope = projectedSlope(w, alpha);
    if (slope <= 0.0) return 0.0;
    const double a = 1.0 / slope;
    // Heitz 2014, section 5.2, exact and not the rational fit of Walter et al. 2007:
    // (erf(a) - 1) / 2 + exp(-a^2) / (2 a sqrt(pi)); rounding may leave it just below 0.
    const double lambda = 0.5 * (std::exp(-square(a)) / (a * std::sqrt(kPi)) - std::erfc(a));
    return std::max(0.0, lambda);
}

double correlatedReflection(double distribution, double lambda_o, double lambda_i, const Vec3d& wo,
                            const Vec3d& wi)
{
    return distribution / (4.0 * wo.z * wi.z * (1.0 + lambda_o + lambda_i));
}

ModelParameter alphaParameter(const std::string& name, double initial, const std::string& meaning)
{
    return scalarParameter(name, initial, kRoughnessMin, kRoughnessMax, meaning);
}

std::vector<ModelParameter> withRoughness(std::vector<ModelParameter> parameters, double initial)
{
    ModelParameter both = alphaParameter("alpha", initial, "roughness, sets alpha_x and alpha_y");
    both.kind = ModelParameter::Kind::shorthand;
    both.sets = {"alpha_x", "alpha_y"};
    parameters.push_back(both);
    parameters.push_back(alphaParameter("alpha_x", initial, "roughness (slope) along the tangent"));
    parameters.push_back(
        alphaParameter("alpha_y", initial, "roughness (slope) across the tangent"));
    return parameters;
}

std::vector<ModelParameter> microfacetParameters()
{
    return withRoughness({albedoParameter("f0", 0.04, "Fresnel reflectance at normal incidence"),
                          albedoParameter("kd", 0.0, "albedo of the Lambertian part")},
                         0.1);
}

Roughness roughnessOf(const ModelValues& values)
{
    return {scalarOf(values, "alpha_x"), scalarOf(values, "alpha_y")};
}

bool roughnessIsIsotropic(const ModelValues& values)
{
    const Roughness alpha = roughnessOf(values);
    return alpha.x == alpha.y;
}

bool hasNoDiffusePart(const ModelValues& values)
{
    return colourOf(values, "kd") == Vec3d(0.0);
}

}  // namespace fbrdf

// Microfacet.h - half vectors, Schlick's Fresnel factor, and the two distributions of microfacet
// normals with their masking: what several models are made of.
// Directions are unit and above the horizon by at least the cosine that makeModelSource promises.
#pragma once
#include "ModelBuild.h"

namespace fbrdf {

inline double square(double x)
{
    return x * x;
}

/// Half vector of a pair and the angle between it and either direction.
struct HalfGeometry {
    Vec3d h;
    double cosTheta_d;     ///< wi.h = wo.h = |wi + wo| / 2, in (0, 1]
    double sineSquared_h;  ///< sin^2 theta_h = h_x^2 + h_y^2: no cancellation near the pole
    HalfGeometry(const Vec3d& wo, const Vec3d& wi);
    double complement_h() const { return sineSquared_h / (1.0 + h.z); }  ///< 1 - cos theta_h
};

/// (1 - cosine)^5, the weight of Schlick 1994.
double schlickWeight(double cosine);
/// f0 + (1 - f0) (1 - cosine)^5, Schlick 1994.
Vec3d schlickFresnel(const Vec3d& f0, double cosine);

/// Roughness along the tangent and across it.
struct Roughness {
    double x, y;
};

/// D(h): integral of D cos theta_h over the hemisphere is 1.
double ggxDistribution(const HalfGeometry& half, const Roughness& alpha);
double beckmannDistribution(const HalfGeometry& half, const Roughness& alpha);

/// Smith's Lambda(w); masking alone is 1 / (1 + Lambda(w)).
double ggxLambda(const Vec3d& w, const Roughness& alpha);
double beckmannLambda(const Vec3d& w, const Roughness& alpha);

/// D G2 / (4 cos cos) with the height-correlated G2 of Heitz 2014, Eq. 99.
double correlatedReflection(double distribution, double lambda_o, double lambda_i, const Vec3d& wo,
                            const Vec3d& wi);

ModelParameter alphaParameter(const std::string& name, double initial, const std::string& meaning);
/// The parameters with alpha_x, alpha_y and the shorthand alpha behind them.
std::vector<ModelParameter> withRoughness(std::vector<ModelParameter> parameters, double initial);
/// f0, kd, alpha, alpha_x, alpha_y: the parameters of ggx and beckmann.
std::vector<ModelParameter> microfacetParameters();
Roughness roughnessOf(const ModelValues& values);
bool roughnessIsIsotropic(const ModelValues& values);
/// A Lambertian added to microfacets that may reflect all light leaves no room for it.
bool hasNoDiffusePart(const ModelValues& values);

/// What `make` of a model is, for microfacets of one of the distributions over a Lambertian:
/// Cook and Torrance 1982, with the 1 / (4 cos cos) of Walter et al. 2007, Eq. 20.
template <double (*distribution)(const HalfGeometry&, const Roughness&),
          double (*lambda)(const Vec3d&, const Roughness&)>
BrdfFunction microfacetsOverLambertian(const ModelValues& values)
{
    const Roughness alpha = roughnessOf(values);
    const Vec3d f0 = colourOf(values, "f0"), diffuse = colourOf(values, "kd") / kPi;
    return [=](const Vec3d& wo, const Vec3d& wi) {
        const HalfGeometry half(wo, wi);
        const double reflection = correlatedReflection(distribution(half, alpha), lambda(wo, alpha),
                                                       lambda(wi, alpha), wo, wi);
        return diffuse + schlickFresnel(f0, half.cosTheta_d) * reflection;
    };
}

}  // namespace fbrdf

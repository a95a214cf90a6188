// Microfacets with the ABC distribution, as fitted to the MERL materials.
#include "Microfacet.h"

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

/// Unpolarised Fresnel reflectance of a dielectric: Cook and Torrance 1982, section 5.
double dielectricFresnel(double cosine, double eta)
{
    const double g = std::sqrt(eta * eta - 1.0 + cosine * cosine);
    const double ratio = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0);
    return 0.5 * square((g - cosine) / (g + cosine)) * (1.0 + square(ratio));
}

/// min(1, 2 (n.h)(n.wo)/(h.wo), 2 (n.h)(n.wi)/(h.wi)): masking of V-grooves, Torrance and Sparrow
/// 1967.
double grooveMasking(const HalfGeometry& half, double lowerCosine)
{
    return std::min(1.0, 2.0 * half.h.z * lowerCosine / half.cosTheta_d);
}

BrdfFunction make(const ModelValues& values)
{
    const Vec3d diffuse = colourOf(values, "kd") / kPi, a = colourOf(values, "A");
    const double b = scalarOf(values, "B"), c = scalarOf(values, "C");
    const double eta = scalarOf(values, "eta");
    return [=](const Vec3d& wo, const Vec3d& wi) {
        const HalfGeometry half(wo, wi);
        // Low et al. 2012, microfacet model: S(x) = A / (1 + B x)^C at x = 1 - cos theta_h,
        // f = kd / pi + F S G / (pi cos cos).
        const double shape = std::pow(1.0 + b * half.complement_h(), -c);
        const double scale = dielectricFresnel(half.cosTheta_d, eta) *
                             grooveMasking(half, std::min(wo.z, wi.z)) / (kPi * wo.z * wi.z);
        return diffuse + a * (shape * scale);
    };
}

}  // namespace

// The ranges contain every published fit with room; the defaults are the paper's blue-rubber, red
// channel.
Model abcModel()
{
    return {"abc",
            "ABC microfacets",
            "Low, Kronander, Ynnerman, Unger 2012, BRDF Models for Accurate and Efficient "
            "Rendering of Glossy Surfaces; the microfacet variant; published parameters are in "
            "units of the MERL reader",
            {colourParameter("kd", 0.0354, 0.0, 10.0, "diffuse reflectance"),
             colourParameter("A", 1.29571, 0.0, 1e6, "height of the distribution"),
             scalarParameter("B", 37.265716, 0.0, 1e9, "inverse width of the distribution"),
             scalarParameter("C", 1.565906, 0.0, 100.0, "fall-off of the distribution"),
             scalarParameter("eta", 1.44861, 1.0, 1000.0, "relative index of refraction")},
            always,
            {"", never},
            make};
}

}  // namespace fbrdf

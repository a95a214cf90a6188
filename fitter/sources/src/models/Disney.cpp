// Disney's principled BRDF of 2012, reflection only.
#include "Microfacet.h"

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

double mix(double a, double b, double t)
{
    return a + (b - a) * t;
}

Vec3d mix(const Vec3d& a, const Vec3d& b, double t)
{
    return a + (b - a) * t;
}

/// Everything that does not depend on the directions.
struct Disney {
    Vec3d base, specular0, sheen;
    double subsurface, roughness, dielectric;  ///< dielectric: 1 - metallic
    Roughness alpha;
    double alphaMasking, clearcoat, alphaClearcoat;

    explicit Disney(const ModelValues& values);
    Vec3d operator()(const Vec3d& wo, const Vec3d& wi) const;
    double diffuse(double cos_o, double cos_i, double cosTheta_d) const;
    double clearcoatLobe(const HalfGeometry& half, double cos_o, double cos_i) const;
};

/// The hue of a colour at luminance 1; white for black. Weights as in Disney's code: .3, .6, .1.
Vec3d tintOf(const Vec3d& colour)
{
    const double luminance = 0.3 * colour.x + 0.6 * colour.y + 0.1 * colour.z;
    return luminance > 0.0 ? colour / luminance : Vec3d(1.0);
}

Disney::Disney(const ModelValues& values)
{
    const auto scalar = [&](const char* name) { return scalarOf(values, name); };
    base = colourOf(values, "baseColor");
    const Vec3d tint = tintOf(base);
    const Vec3d white(1.0);
    // Burley 2012, section 5.4: specular scales F0 within [0, 0.08].
    const Vec3d dielectric0 = 0.08 * scalar("specular") * mix(white, tint, scalar("specularTint"));
    specular0 = mix(dielectric0, base, scalar("metallic"));
    sheen = scalar("sheen") * mix(white, tint, scalar("sheenTint"));
    subsurface = scalar("subsurface");
    roughness = scalar("roughness");
    dielectric = 1.0 - scalar("metallic");
    // Burley 2012, section 5.4: alpha = roughness^2, aspect limited to 10:1.
    const double aspect = std::sqrt(1.0 - 0.9 * scalar("anisotropic"));
    alpha = {std::max(1e-3, square(roughness) / aspect),
             std::max(1e-3, square(roughness) * aspect)};
    // Burley 2012, section 5.6: the roughness of the masking is remapped to [0.5, 1] and squared.
    alphaMasking = square(0.5 + 0.5 * roughness);
    clearcoat = scalar("clearcoat");
    alphaClearcoat = mix(0.1, 0.001, scalar("clearcoatGloss"));
}

/// Burley 2012, section 5.3 (Fresnel-weighted, retro-reflective), and the flatter one for
/// subsurface scattering after Hanrahan and Krueger 1993; times pi.
double Disney::diffuse(double cos_o, double cos_i, double cosTheta_d) const
{
    const double weight_o = schlickWeight(cos_o), weight_i = schlickWeight(cos_i);
    const double grazing = square(cosTheta_d) * roughness;
    const double fd90 = 0.5 + 2.0 * grazing;
    const double surface = mix(1.0, fd90, weight_o) * mix(1.0, fd90, weight_i);
    const double fss = mix(1.0, grazing, weight_o) * mix(1.0, grazing, weight_i);
    const double below = 1.25 * (fss * (1.0 / (cos_o + cos_i) - 0.5) + 0.5);
    return mix(surface, below, subsurface);
}

/// Walter et al. 2007, Eq. 34, divided by 2 cos: two of these are G / (4 cos cos).
double maskingOverCosine(double cosine, double alpha)
{
    const double a = square(alpha), b = square(cosine);
    return 1.0 / (cosine + std::sqrt(a + b - a * b));
}

/// Burley 2012, appendix B, Eq. 4: GTR with gamma = 1, its denominator without cancellation.
double gtr1(double sineSquared_h, double cosine_h, double alpha)
{
    const double a = square(alpha);
    return (1.0 - a) / (-kPi * std::log(a) * (a * square(cosine_h) + sineSquared_h));
}

double Disney::clearcoatLobe(const HalfGeometry& half, double cos_o, double cos_i) const
{
    // Burley 2012, section 5.4: index 1.5, so F0 = 0.04; fixed masking roughness 0.25.
    const double fresnel = mix(0.04, 1.0, schlickWeight(half.cosTheta_d));
    const double masking = maskingOverCosine(cos_o, 0.25) * maskingOverCosine(cos_i, 0.25);
    return 0.25 * clearcoat * fresnel * masking *
           gtr1(half.sineSquared_h, half.h.z, alphaClearcoat);
}

Vec3d Disney::operator()(const Vec3d& wo, const Vec3d& wi) const
{
    const HalfGeometry half(wo, wi);
    const double weight_d = schlickWeight(half.cosTheta_d);
    const Vec3d body = base * (diffuse(wo.z, wi.z, half.cosTheta_d) / kPi) + sheen * weight_d;
    const double lobe = ggxDistribution(half, alpha) * maskingOverCosine(wo.z, alphaMasking) *
                        maskingOverCosine(wi.z, alphaMasking);
    return body * dielectric + schlickFresnel(specular0, half.cosTheta_d) * lobe +
           Vec3d(clearcoatLobe(half, wo.z, wi.z));
}

BrdfFunction make(const ModelValues& values)
{
    return Disney(values);
}

// Besides materials without anisotropy these are the narrowest highlights, whose width is clamped
// to the same least value in both directions.
bool isotropic(const ModelValues& values)
{
    const Roughness alpha = Disney(values).alpha;
    return alpha.x == alpha.y;
}

ModelParameter fraction(const char* name, double initial, const char* meaning)
{
    return scalarParameter(name, initial, 0.0, 1.0, meaning);
}

}  // namespace

Model disneyModel()
{
    return {"disney",
            "Disney principled, 2012",
            "Burley 2012, Physically-Based Shading at Disney; its separable masking with remapped "
            "roughness; baseColor is linear here",
            {albedoParameter("baseColor", 0.5, "colour of the surface"),
             fraction("subsurface", 0.0, "flatter diffuse shape"),
             fraction("metallic", 0.0, "0 dielectric, 1 metal"),
             fraction("specular", 0.5, "F0 of a dielectric, in units of 0.08"),
             fraction("specularTint", 0.0, "tint of the dielectric highlight"),
             fraction("roughness", 0.5, "square root of the GGX roughness"),
             fraction("anisotropic", 0.0, "0 round, 1 stretched 10:1"),
             fraction("sheen", 0.0, "grazing term of cloth"),
             fraction("sheenTint", 0.5, "tint of the sheen"),
             fraction("clearcoat", 0.0, "second highlight"),
             fraction("clearcoatGloss", 1.0, "0 satin, 1 gloss")},
            isotropic,
            {"", never},
            make};
}

}  // namespace fbrdf

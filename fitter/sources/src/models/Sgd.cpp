// Shifted-gamma microfacets, as fitted to the MERL materials.
#include "Microfacet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf {
namespace {

/// The parameters of one channel, with the letters of the paper.
struct Channel {
    double kd, ks, alpha, p, f0, f1, K, Lambda, c, k, theta0;
};

Channel channelOf(const ModelValues& values, int i)
{
    const auto at = [&](const char* name) { return colourOf(values, name)[i]; };
    return {at("kd"), at("ks"),     at("alpha"), at("p"), at("f0"),    at("f1"),
            at("K"),  at("Lambda"), at("c"),     at("k"), at("theta0")};
}

/// Bagher et al. 2012, section 3: D = P22(tan^2 theta_h) / (pi cos^4 theta_h) with the shifted
/// gamma P22(x) = K exp(-y) / y^p, y = alpha + x / alpha.
double distribution(const Channel& m, const HalfGeometry& half)
{
    const double cosineSquared = half.h.z * half.h.z;
    const double y = m.alpha + half.sineSquared_h / cosineSquared / m.alpha;
    return m.K * std::exp(-y) / (kPi * std::pow(y, m.p) * cosineSquared * cosineSquared);
}

/// Bagher et al. 2012, section 3: 1 + Lambda (1 - exp(c (theta - theta0)^k)), within [0, 1].
double masking(const Channel& m, double theta)
{
    const double x = theta - m.theta0;
    if (x <= 0.0) return 1.0;
    // In logs: the published c reach 1e109 and k 855. Where e^power overflows the masking is 0 long
    // since; clamped to e^700 so that Lambda = 0 does not meet infinity.
    const double power = std::exp(std::log(m.c) + m.k * std::log(x));
    return std::clamp(1.0 - m.Lambda * std::expm1(std::min(700.0, power)), 0.0, 1.0);
}

/// Bagher et al. 2012, section 3: Schlick's form with a linear term; fits may leave it negative.
double fresnel(const Channel& m, double cosTheta_d)
{
    return std::max(0.0, m.f0 - cosTheta_d * m.f1 + schlickWeight(cosTheta_d) * (1.0 - m.f0));
}

BrdfFunction make(const ModelValues& values)
{
    const std::array<Channel, 3> channels = {channelOf(values, 0), channelOf(values, 1),
                                             channelOf(values, 2)};
    return [=](const Vec3d& wo, const Vec3d& wi) {
        const HalfGeometry half(wo, wi);
        const double theta_o = zenithAngle(wo), theta_i = zenithAngle(wi);
        Vec3d f(0.0);
        for (int i = 0; i < 3; ++i) {
            const Channel& m = channels[static_cast<size_t>(i)];
            const double specular = m.ks * fresnel(m, half.cosTheta_d) * distribution(m, half) *
                                    masking(m, theta_o) * masking(m, theta_i) / wo.z / wi.z;
            f[i] = (m.kd + specular) / kPi;
        }
        return f;
    };
}

}  // namespace

// The ranges contain every published fit (100 materials x 3 channels) with room; the defaults are
// the paper's blue-rubber, red channel.
Model sgdModel()
{
    return {"sgd",
            "Shifted gamma distribution (SGD)",
            "Bagher, Soler, Holzschuch 2012, Accurate Fitting of Measured Reflectances Using a "
            "Shifted Gamma Micro-Facet Distribution; published parameters are in units of the MERL "
            "reader; the Fresnel factor is clamped at 0",
            {colourParameter("kd", 0.0371302, 0.0, 10.0, "diffuse reflectance"),
             colourParameter("ks", 0.384232, 0.0, 100.0, "specular reflectance (albedo)"),
             colourParameter("alpha", 0.218197, 1e-6, 10.0, "width of the distribution"),
             colourParameter("p", 0.815054, 0.0, 20.0, "exponent of the distribution's tail"),
             colourParameter("f0", 0.0631713, -10.0, 20.0, "Fresnel term (eta0)"),
             colourParameter("f1", 0.0478254, -10.0, 20.0, "Fresnel linear term (eta1)"),
             colourParameter("K", 4.41586, 0.0, 1e9, "normalisation of the distribution"),
             colourParameter("Lambda", 3.77807, 0.0, 1e9, "masking: scale"),
             colourParameter("c", 1.2941e-07, 0.0, 1e300, "masking: rate"),
             colourParameter("k", 19.8046, 1e-3, 5000.0, "masking: exponent"),
             colourParameter("theta0", -0.499472, -1.6, 1.6, "masking: angle of onset, radians")},
            always,
            {"", never},
            make};
}

}  // namespace fbrdf

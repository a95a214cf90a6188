// Physical optics of a Gaussian random surface: the directional diffuse part of He et al. 1991.
//
// What is simplified, and why:
// - The specular spike (Eq. 72) is left out: it is a delta function, for which a table of f has no
// place.
// - |F|^2 is Schlick's approximation at theta_d instead of complex, polarised Fresnel.
// - G (Eq. 76) for unpolarised light: s and p of either ray span the plane normal to it, so
//   (s_r.k_i)^2 + (p_r.k_i)^2 = |k_r x k_i|^2, the quotient cancels, and with |wi + wo| =
//   2 cos theta_d and wi.z + wo.z = 2 cos theta_d cos theta_h:
//     G = (|wi + wo|^2 / (wi.z + wo.z))^2 = (2 cos theta_d / cos theta_h)^2.
// - Eq. 25 has the exponential that the paper's errata restore; it is Beckmann's Lambda.
// For sigma >> wavelength the model becomes Beckmann microfacets with alpha = 2 sigma0 / tau.
#include "Microfacet.h"

#include <algorithm>

namespace fbrdf {
namespace {

/// Dominant wavelengths of the Rec. 709 primaries, micrometres.
constexpr double kWavelength[3] = {0.611, 0.549, 0.464};

/// ln m!, m >= 1. Stirling's series, good to 1e-13 from 16 on, after stepping up to there.
/// std::lgamma writes a global, so threads could not call it.
double logFactorial(double m)
{
    double shift = 0.0;
    while (m < 16.0) shift += std::log(m += 1.0);
    const double r = 1.0 / m;
    const double series = r * (1.0 / 12.0 - r * r * (1.0 / 360.0 - r * r / 1260.0));
    return 0.5 * std::log(2.0 * kPi * m) + m * (std::log(m) - 1.0) + series - shift;
}

/// sum over m >= 1 of g^m e^-g / (m! m) e^(-b/m), the series of He et al. 1991, Eq. 78.
/// The terms rise to one maximum and fall: it is found by bisection and summed outwards.
///
/// Far from m = 1 the terms are a bell of standard deviation w, (1/m + 2b/m^3)^(-1/2), and every
/// s-th term times s has the same sum: the trapezoidal rule on a bell errs by 2 e^(-2 pi^2
/// w^2/s^2), which is e^-40 for s = 0.7 w. So a sum never has more than a hundred terms.
class RoughnessSeries {
public:
    RoughnessSeries(double g, double b) : g_(g), logG_(std::log(g)), b_(b) {}

    double sum() const
    {
        const double peak = peakIndex();
        const double step = stepAt(peak);
        const double total = step == 1.0 ? sumOfAll(peak) : sumOfEvery(step, peak);
        return step * total * std::exp(logTerm(peak));
    }

private:
    static constexpr double kNegligible = 1e-14;  ///< of the sum: twelve digits and room
    static constexpr double kFarFromOne = 64.0;   ///< the bell's left tail at 1 is below e^-60

    double logTerm(double m) const
    {
        return m * logG_ - g_ - logFactorial(m) - std::log(m) - b_ / m;
    }
    /// Term m + 1 over term m; falls with m.
    double ratio(double m) const
    {
        return g_ * m / square(m + 1.0) * std::exp(b_ / (m * (m + 1.0)));
    }
    double peakIndex() const
    {
        double upper = 1.0;
        while (ratio(upper) > 1.0) upper *= 2.0;
        double lower = 0.5 * upper;
        while (upper - lower > 1.0) {
            const double middle = std::floor(0.5 * (lower + upper));
            (ratio(middle) > 1.0 ? lower : upper) = middle;
        }
        return upper;
    }
    double stepAt(double peak) const
    {
        if (peak < kFarFromOne) return 1.0;
        const double width = peak / std::sqrt(peak + 2.0 * b_ / peak);
        return std::max(1.0, std::floor(0.7 * width));
    }
    /// All terms over that of the peak, each from its neighbour.
    double sumOfAll(double peak) const
    {
        double total = 1.0, term = 1.0;
        for (double m = peak; term > kNegligible * total; m += 1.0) total += (term *= ratio(m));
        term = 1.0;
        for (double m = peak - 1.0; m >= 1.0 && term > kNegligible * total; m -= 1.0)
            total += (term /= ratio(m));
        return total;
    }
    /// Every step-th term over that of the peak.
    double sumOfEvery(double step, double peak) const
    {
        const double peakLog = logTerm(peak);
        double total = 1.0;
        for (const double stride : {step, -step}) {
            double term = 1.0;
            for (double m = peak + stride; m >= 1.0 && term > kNegligible * total; m += stride)
                total += term = std::exp(logTerm(m) - peakLog);
        }
        return total;
    }
    double g_, logG_, b_;
};

struct Surface {
    double sigma0;  ///< standard deviation of the height, micrometres
    double tau;     ///< correlation length, micrometres
    /// Beckmann roughness of the same slopes.
    double slope() const { return 2.0 * sigma0 / tau; }
};

/// He et al. 1991, Eqs. 82 and 83: tan(theta) erfc(tau cot(theta) / (2 sigma0)).
double shadowSlope(const Vec3d& w, double alpha)
{
    const double tangent = std::hypot(w.x, w.y) / w.z;
    return tangent > 0.0 ? tangent * std::erfc(1.0 / (alpha * tangent)) : 0.0;
}

/// sigma^2: what is left of the roughness where the lower parts are in shadow. He et al. 1991,
/// Eq. 80, with z0 = sigma0 x from Eq. 81: sqrt(pi/2) x = (Ki + Kr) / 4 e^(-x^2/2). Squared, y =
/// x^2 solves y e^y = c; Newton on ln y + y - ln c, which is concave and rising, from below.
double effectiveVariance(const Surface& surface, const Vec3d& wo, const Vec3d& wi)
{
    const double k = shadowSlope(wo, surface.slope()) + shadowSlope(wi, surface.slope());
    const double c = square(0.25 * k) * 2.0 / kPi;
    if (c < 1e-300) return square(surface.sigma0);
    const double logC = std::log(c);
    double y = c < 1.0 ? c / (1.0 + c) : std::max(0.5, 0.5 * logC);
    for (int i = 0; i < 20; ++i) {
        const double step = (logC - y - std::log(y)) / (1.0 + 1.0 / y);
        y += step;
        if (std::abs(step) <= 1e-15 * y) break;
    }
    return square(surface.sigma0) / (1.0 + y);
}

/// He et al. 1991, Eqs. 24 and 25.
double shadowing(const Vec3d& w, double alpha)
{
    const double tangent = std::hypot(w.x, w.y) / w.z;
    if (tangent <= 0.0) return 1.0;
    const double lit = 1.0 - 0.5 * std::erfc(1.0 / (alpha * tangent));
    return lit / (1.0 + beckmannLambda(w, {alpha, alpha}));
}

/// D of He et al. 1991, Eqs. 78 and 79. `sum`: wi + wo.
double distribution(double variance, double tau, double wavelength, const Vec3d& sum)
{
    const double wavenumber = 2.0 * kPi / wavelength;
    const double g = variance * square(wavenumber * sum.z);
    const double b = 0.25 * square(wavenumber * tau) * (square(sum.x) + square(sum.y));
    return square(0.25 * wavenumber * tau) * RoughnessSeries(g, b).sum();
}

BrdfFunction make(const ModelValues& values)
{
    const Surface surface{scalarOf(values, "sigma"), scalarOf(values, "tau")};
    const Vec3d f0 = colourOf(values, "f0"), diffuse = colourOf(values, "kd") / kPi;
    return [=](const Vec3d& wo, const Vec3d& wi) {
        const HalfGeometry half(wo, wi);
        const double alpha = surface.slope();
        const double geometry = square(2.0 * half.cosTheta_d / half.h.z);
        // He et al. 1991, Eq. 71: F G S D / (pi cos cos).
        const double scale =
            geometry * (shadowing(wo, alpha) / wo.z) * (shadowing(wi, alpha) / wi.z) / kPi;
        const double variance = effectiveVariance(surface, wo, wi);
        const Vec3d fresnel = schlickFresnel(f0, half.cosTheta_d);
        Vec3d f = diffuse;
        for (int c = 0; c < 3; ++c)
            f[c] +=
                fresnel[c] * scale * distribution(variance, surface.tau, kWavelength[c], wo + wi);
        return f;
    };
}

}  // namespace

Model heTorranceModel()
{
    return {"he-torrance",
            "He-Torrance, directional and uniform diffuse",
            "He, Torrance, Sillion, Greenberg 1991, A Comprehensive Physical Model for Light "
            "Reflection; without the specular spike, Schlick 1994 Fresnel, unpolarised",
            {albedoParameter("kd", 0.0, "uniform diffuse albedo"),
             albedoParameter("f0", 0.9, "Fresnel reflectance at normal incidence"),
             scalarParameter("sigma", 0.3, 0.001, 5.0, "RMS height of the surface, micrometres"),
             scalarParameter("tau", 3.0, 0.1, 100.0, "correlation length, micrometres")},
            always,
            {"kd = 0", hasNoDiffusePart},
            make};
}

}  // namespace fbrdf

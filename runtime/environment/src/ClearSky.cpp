// Preetham, Shirley, Smits 1999, "A Practical Analytic Model for Daylight", appendix A.1 and A.2.
#include "SkyModels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf {
namespace {

/// Coefficients A to E of Perez' distribution: slope and offset over turbidity.
using Perez = std::array<std::array<double, 2>, 5>;
constexpr Perez kLuminance = {{{0.1787, -1.4630},
                               {-0.3554, 0.4275},
                               {-0.0227, 5.3251},
                               {0.1206, -2.5771},
                               {-0.0670, 0.3703}}};
constexpr Perez kChromaX = {{{-0.0193, -0.2592},
                             {-0.0665, 0.0008},
                             {-0.0004, 0.2125},
                             {-0.0641, -0.8989},
                             {-0.0033, 0.0452}}};
constexpr Perez kChromaY = {{{-0.0167, -0.2608},
                             {-0.0950, 0.0092},
                             {-0.0079, 0.2102},
                             {-0.0441, -1.6537},
                             {-0.0109, 0.0529}}};

/// Rows for T^2, T, 1; columns for theta_s^3, ^2, ^1, 1.
using ZenithChroma = std::array<std::array<double, 4>, 3>;
constexpr ZenithChroma kZenithX = {{{0.00166, -0.00375, 0.00209, 0.0},
                                    {-0.02903, 0.06377, -0.03202, 0.00394},
                                    {0.11693, -0.21196, 0.06052, 0.25886}}};
constexpr ZenithChroma kZenithY = {{{0.00275, -0.00610, 0.00317, 0.0},
                                    {-0.04214, 0.08970, -0.04153, 0.00516},
                                    {0.15346, -0.26756, 0.06670, 0.26688}}};

/// Two directions as the model sees them.
struct SkyAngles {
    double cosTheta, gamma;  ///< from the zenith; from the sun
};

double perez(const Perez& coefficients, double turbidity, const SkyAngles& at)
{
    std::array<double, 5> c{};
    for (size_t i = 0; i < 5; ++i) c[i] = coefficients[i][0] * turbidity + coefficients[i][1];
    // B is negative: the first factor has a limit at the horizon.
    const double horizon = std::exp(c[1] / std::max(at.cosTheta, 1e-4)),
                 cosine = std::cos(at.gamma);
    return (1.0 + c[0] * horizon) *
           (1.0 + c[2] * std::exp(c[3] * at.gamma) + c[4] * cosine * cosine);
}

double zenithChroma(const ZenithChroma& rows, double turbidity, double sun)
{
    double value = 0.0;
    for (const auto& row : rows)
        value = value * turbidity + ((row[0] * sun + row[1]) * sun + row[2]) * sun + row[3];
    return value;
}

/// kcd/m^2.
double zenithLuminance(double turbidity, double sun)
{
    const double chi = (4.0 / 9.0 - turbidity / 120.0) * (kPi - 2.0 * sun);
    return (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192;
}

/// Linear Rec. 709 of CIE xyY; the sky's blues are inside of the gamut or a little outside.
Vec3d rgbOf(double x, double y, double luminance)
{
    const double X = x / y * luminance, Z = (1.0 - x - y) / y * luminance;
    const Vec3d rgb(3.2406 * X - 1.5372 * luminance - 0.4986 * Z,
                    -0.9689 * X + 1.8758 * luminance + 0.0415 * Z,
                    0.0557 * X - 0.2040 * luminance + 1.0570 * Z);
    return glm::max(rgb, Vec3d(0.0));
}

}  // namespace

Vec3d ClearSky::radiance(const Vec3d& direction) const
{
    const double sun = std::acos(std::clamp(toSun.y, -1.0, 1.0));
    const SkyAngles at{direction.y, std::acos(std::clamp(glm::dot(direction, toSun), -1.0, 1.0))};
    const SkyAngles zenith{1.0, sun};
    const auto relative = [&](const Perez& coefficients) {
        return perez(coefficients, turbidity, at) / perez(coefficients, turbidity, zenith);
    };
    return rgbOf(zenithChroma(kZenithX, turbidity, sun) * relative(kChromaX),
                 zenithChroma(kZenithY, turbidity, sun) * relative(kChromaY),
                 zenithLuminance(turbidity, sun) * relative(kLuminance));
}

Vec3d ClearSky::sunIrradiance() const
{
    // Illuminance above the atmosphere in klx (IES Lighting Handbook: 127.5), of the colour of the
    // sun there, about 5900 K.
    const Vec3d above = 127.5 * Vec3d(1.03, 0.99, 0.99);
    // Attenuation by molecules, aerosols and ozone at wavelengths of the three primaries, in um.
    const Vec3d wavelength(0.61, 0.55, 0.465), ozone(0.12, 0.085, 0.008);  // per cm
    const double degrees = std::acos(std::clamp(toSun.y, 0.0, 1.0)) / kDegree;
    const double mass = 1.0 / (std::max(toSun.y, 0.0) + 0.15 * std::pow(93.885 - degrees, -1.253));
    const double beta = 0.04608 * turbidity - 0.04586;
    Vec3d result;
    for (int c = 0; c < 3; ++c) {
        const double rayleigh = 0.008735 * std::pow(wavelength[c], -4.08),
                     aerosol = beta * std::pow(wavelength[c], -1.3);
        result[c] = above[c] * std::exp(-mass * (rayleigh + aerosol + 0.35 * ozone[c]));
    }
    return result;
}

}  // namespace fbrdf

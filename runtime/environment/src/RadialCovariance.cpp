#include "RadialCovariance.h"

#include <fbrdf/brdf/LobeTable.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

// A lobe of level 0 has no more than 1e-3 of itself beyond this degree.
constexpr int kDegrees = 400;
constexpr int kQuadrature = 4000;
constexpr int kEntries = 1024;

/// Tables are over u = sin(g / 2)^0.5, dense near 0, where narrow lobes are.
double placeOf(double cosine)
{
    return std::sqrt(std::sqrt(std::max(0.0, 0.5 * (1.0 - cosine)))) * (kEntries - 1);
}

double cosineOf(int entry)
{
    const double u = static_cast<double>(entry) / (kEntries - 1);
    return 1.0 - 2.0 * u * u * u * u;
}

/// P_0 to P_(kDegrees - 1) at x.
void legendre(double x, std::vector<double>& p)
{
    p.assign(kDegrees, 1.0);
    p[1] = x;
    for (size_t n = 2; n < p.size(); ++n) {
        const auto k = static_cast<double>(n);
        p[n] = ((2.0 * k - 1.0) * x * p[n - 1] - (k - 1.0) * p[n - 2]) / k;
    }
}

/// Coefficients of a radial function: its integral against each polynomial over the sphere.
template <class Function>
std::vector<double> coefficients(const Function& f)
{
    std::vector<double> sums(kDegrees, 0.0), p;
    for (int i = 0; i < kQuadrature; ++i) {
        // Dense near 0, as in LobeDictionary.cpp.
        const double u = (i + 0.5) / kQuadrature, g = kPi * u * u * u;
        legendre(std::cos(g), p);
        const double weight =
            2.0 * kPi * f(std::cos(g)) * std::sin(g) * 3.0 * kPi * u * u / kQuadrature;
        for (size_t n = 0; n < p.size(); ++n) sums[n] += weight * p[n];
    }
    return sums;
}

}  // namespace

double radianceCovariance(double cosine)
{
    const double g = std::acos(std::clamp(cosine, -1.0, 1.0));
    return 2.0 + std::exp(-g / 0.7) + std::exp(-g / 0.1);
}

RadialCovariance::RadialCovariance()
{
    const int levels = static_cast<int>(std::lround(kCosineLevel / kStep)) + 1;
    const std::vector<double> prior = coefficients(radianceCovariance);
    std::vector<std::vector<double>> lobes;
    for (int l = 0; l < levels; ++l)
        lobes.push_back(coefficients([&](double c) { return lobeValue(c, l * kStep); }));
    direction_.assign(lobes.size(), Radial(kEntries));
    lobe_ = cosine_ = direction_;
    std::vector<double> p;
    for (int entry = 0; entry < kEntries; ++entry) {
        legendre(cosineOf(entry), p);
        const auto e = static_cast<size_t>(entry);
        for (size_t l = 0; l < lobes.size(); ++l) {
            double direction = 0.0, lobe = 0.0, cosine = 0.0;
            for (size_t n = 0; n < p.size(); ++n) {
                const double term = (2.0 * static_cast<double>(n) + 1.0) / (4.0 * kPi) * prior[n] *
                                    lobes[l][n] * p[n];
                direction += term;
                lobe += term * lobes[l][n];
                cosine += term * lobes.back()[n];
            }
            direction_[l][e] = static_cast<float>(direction);
            lobe_[l][e] = static_cast<float>(lobe);
            cosine_[l][e] = static_cast<float>(cosine);
        }
    }
}

double RadialCovariance::at(const Radial& table, double cosine)
{
    const double place = placeOf(cosine);
    const auto below = std::min(static_cast<size_t>(place), table.size() - 2);
    const double fraction = place - static_cast<double>(below);
    return double(table[below]) * (1.0 - fraction) + double(table[below + 1]) * fraction;
}

}  // namespace fbrdf

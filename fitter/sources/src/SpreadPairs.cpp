#include "SpreadPairs.h"

#include <fbrdf/brdf/HalfDifference.h>

#include <array>
#include <cmath>

namespace fbrdf {
namespace {

using Point = std::array<double, 4>;

/// Point of the recurrence: the real root g of x^5 = x + 1 gives steps 1/g, 1/g^2, 1/g^3, 1/g^4.
Point recurrencePoint(size_t index)
{
    constexpr double kRoot = 1.1673039782614187;
    Point point{};
    double step = 1.0;
    for (double& u : point) {
        step /= kRoot;
        u = std::fmod(0.5 + double(index + 1) * step, 1.0);
    }
    return point;
}

Vec3d cosineDirection(double u, double v)
{
    const double radius = std::sqrt(u), phi = 2.0 * kPi * v;
    return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(1.0 - u)};
}

DirectionPair<double> pairAt(size_t index)
{
    const Point u = recurrencePoint(index / 2);
    if (index % 2 == 0) return {cosineDirection(u[0], u[1]), cosineDirection(u[2], u[3])};
    const double theta_h = u[0] * u[0] * kPi / 2;
    return pairFromHalfDifference({theta_h, 2.0 * kPi * u[2], u[1] * kPi / 2, 2.0 * kPi * u[3]});
}

}  // namespace

std::vector<DirectionPair<double>> spreadPairs(size_t count)
{
    const double lowest = std::sin(2.0 * kPi / 180.0);
    std::vector<DirectionPair<double>> pairs;
    std::array<size_t, 2> kept{};  // of each half, so that rejection does not favour one
    for (size_t index = 0; pairs.size() < count; ++index) {
        const DirectionPair<double> pair = pairAt(index);
        const bool above = pair.wo.z > lowest && pair.wi.z > lowest;
        if (!above || kept[index % 2] >= (count + 1 - index % 2) / 2) continue;
        ++kept[index % 2];
        pairs.push_back(pair);
    }
    return pairs;
}

}  // namespace fbrdf

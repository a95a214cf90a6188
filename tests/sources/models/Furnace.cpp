#include "Furnace.h"

#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::test {
namespace {

constexpr int kNodes = 96, kAzimuths = 96;

struct Node {
    double x, weight;
};

/// Gauss-Legendre on [0, 1] by Newton's method on the Legendre polynomial.
std::vector<Node> gaussLegendre(int n)
{
    std::vector<Node> nodes;
    for (int k = 0; k < n; ++k) {
        double x = std::cos(kPi * (k + 0.75) / (n + 0.5)), slope = 1.0;
        for (int iteration = 0; iteration < 20; ++iteration) {
            double previous = 1.0, value = x;
            for (int j = 2; j <= n; ++j) {
                const double next = ((2 * j - 1) * x * value - (j - 1) * previous) / j;
                previous = value;
                value = next;
            }
            slope = n * (x * value - previous) / (x * x - 1.0);
            x -= value / slope;
        }
        nodes.push_back({0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)});
    }
    return nodes;
}

/// f cos of the direction that h reflects wo into, times d omega_i / d omega_h.
Vec3d reflected(const BrdfFunction& f, const Vec3d& wo, const Vec3d& h)
{
    const double cosine = glm::dot(wo, h);
    if (cosine <= 0.0) return Vec3d(0.0);
    const Vec3d wi = glm::normalize(2.0 * cosine * h - wo);
    return wi.z <= 0.0 ? Vec3d(0.0) : f(wo, wi) * (wi.z * 4.0 * cosine);
}

}  // namespace

Vec3d integrateHemisphere(const std::function<Vec3d(const Vec3d& direction)>& g)
{
    static const std::vector<Node> nodes = gaussLegendre(kNodes);
    Vec3d sum(0.0);
    for (const Node& node : nodes) {
        const double u = node.x, theta = 0.5 * kPi * u * u * u;
        const double weight = node.weight * 1.5 * kPi * u * u * std::sin(theta);
        Vec3d ring(0.0);
        for (int k = 0; k < kAzimuths; ++k)
            ring += g(directionFromAngles(theta, 2.0 * kPi * (k + 0.5) / kAzimuths));
        sum += ring * (weight * 2.0 * kPi / kAzimuths);
    }
    return sum;
}

Vec3d directionalAlbedo(const BrdfFunction& f, const Vec3d& wo)
{
    return integrateHemisphere([&](const Vec3d& h) { return reflected(f, wo, h); });
}

double largestAlbedo(const BrdfFunction& f)
{
    double largest = 0.0;
    for (const double degrees : {0.0, 30.0, 50.0, 70.0, 80.0, 87.0})
        for (const double phi : {0.0, 0.8, 0.5 * kPi}) {
            const Vec3d albedo =
                directionalAlbedo(f, directionFromAngles(degrees * kPi / 180.0, phi));
            largest = std::max({largest, albedo.x, albedo.y, albedo.z});
        }
    return largest;
}

bool conserves(const BrdfFunction& f)
{
    return largestAlbedo(f) <= 1.0 + kFurnace;
}

}  // namespace fbrdf::test

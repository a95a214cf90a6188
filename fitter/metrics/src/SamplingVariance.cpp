#include <fbrdf/base/Parallel.h>
#include <fbrdf/metrics/SamplingVariance.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

constexpr int kViewAngles = 12, kViewAzimuths = 4;
// Rings about the mirror direction at pi t^4: the innermost tenth is within a thousandth of a
// degree, the widest ring has 4 degrees. 48 cells on half a ring.
constexpr int kRings = 192, kHalfRing = 48;

double ringAngle(double t)
{
    return kPi * t * t * t * t;
}

std::vector<ReflectedLight::View> viewsOf(bool isotropic)
{
    std::vector<ReflectedLight::View> views;
    const int azimuths = isotropic ? 1 : kViewAzimuths;
    double sum = 0.0;
    for (int i = 0; i < kViewAngles; ++i)
        for (int j = 0; j < azimuths; ++j) {
            const double theta = (i + 0.5) * 0.5 * kPi / kViewAngles;
            // One quadrant is enough for most materials; f counts as it is there.
            const double phi = isotropic ? 0.0 : (j + 0.5) * 0.5 * kPi / azimuths;
            const double weight = std::cos(theta) * std::sin(theta);
            views.push_back({{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                              std::cos(theta)},
                             weight,
                             {},
                             0.0});
            sum += weight;
        }
    for (ReflectedLight::View& view : views) view.weight /= sum;
    return views;
}

/// Fills in the nodes of a view and what it reflects.
void integrate(ReflectedLight::View& view, const Reflectance& f, bool isotropic)
{
    const Vec3d& wo = view.wo;
    const Vec3d mirror(-wo.x, -wo.y, wo.z);
    // One axis in the plane of incidence, about which an isotropic f is symmetric.
    const Vec3d across = glm::normalize(Vec3d(-wo.y, wo.x, 0.0)),
                along = glm::cross(across, mirror);
    const int cells = isotropic ? kHalfRing : 2 * kHalfRing;
    Vec3d sum(0.0);
    for (int ring = 0; ring < kRings; ++ring) {
        const double inner = ringAngle(double(ring) / kRings),
                     outer = ringAngle((ring + 1.0) / kRings),
                     angle = ringAngle((ring + 0.5) / kRings);
        // cos inner - cos outer without cancellation.
        const double solidAngle =
            4.0 * kPi / cells * std::sin(0.5 * (outer + inner)) * std::sin(0.5 * (outer - inner));
        for (int cell = 0; cell < cells; ++cell) {
            const double azimuth = (cell + 0.5) * (isotropic ? kPi : 2.0 * kPi) / cells;
            const Vec3d wi =
                std::cos(angle) * mirror +
                std::sin(angle) * (std::cos(azimuth) * along + std::sin(azimuth) * across);
            if (!(wi.z > 0.0)) continue;
            const Vec3d reflected = glm::max(f(wo, wi), 0.0) * wi.z;
            sum += solidAngle * reflected;
            view.nodes.push_back({wi, solidAngle, glm::dot(reflected, reflected) / 3.0});
        }
    }
    view.square = glm::dot(sum, sum) / 3.0;
}

}  // namespace

ReflectedLight::ReflectedLight(const Reflectance& f, bool isotropic, int threads)
    : threads_(threads), isotropic_(isotropic), views_(viewsOf(isotropic))
{
    parallelTasks(views_.size(), threads_, [&](size_t i) { integrate(views_[i], f, isotropic); });
}

double ReflectedLight::deviation(
    const std::function<double(const Vec3d&, const Vec3d&)>& density) const
{
    std::vector<double> squares(views_.size(), 0.0);
    parallelTasks(views_.size(), threads_, [&](size_t i) {
        for (const Node& node : views_[i].nodes)
            if (node.square > 0.0)
                squares[i] += views_[i].weight * node.solidAngle * node.square /
                              density(views_[i].wo, node.wi);
    });
    double sum = 0.0;
    for (const double square : squares) sum += square;
    return deviationOf(sum);
}

double ReflectedLight::deviationOf(double meanSquare) const
{
    double light = 0.0;
    for (const View& view : views_) light += view.weight * view.square;
    // A black material has nothing to be wrong about.
    return light > 0.0 ? std::sqrt(std::max(0.0, meanSquare / light - 1.0)) : 0.0;
}

}  // namespace fbrdf

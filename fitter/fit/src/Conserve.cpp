#include "Conserve.h"

#include <fbrdf/base/Parallel.h>

#include <fbrdf/metrics/Metrics.h>

#include <algorithm>
#include <vector>

namespace fbrdf {
namespace {

constexpr size_t kIncidences = 45;        // 2 degrees apart
constexpr size_t kAzimuths = 4;           // over half a turn: a turn by pi changes little
constexpr double kBelowOne = 1.0 - 1e-6;  // scales are floats

}  // namespace

double largestAlbedo(const Material& material, int threads)
{
    const BrdfFunction brdf = [&](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(evaluate<float>(material, Vec3f(wo), Vec3f(wi)));
    };
    const size_t azimuths = isIsotropic(material.form) ? 1 : kAzimuths;
    std::vector<double> albedos(kIncidences * azimuths);
    parallelTasks(albedos.size(), threads, [&](size_t i) {
        const double theta = static_cast<double>(i / azimuths) * 2.0 * kPi / 180.0,
                     phi = static_cast<double>(i % azimuths) * kPi / kAzimuths;
        const Vec3d albedo = directionalAlbedo(brdf, theta, phi);
        albedos[i] = std::max({albedo.x, albedo.y, albedo.z});
    });
    return *std::max_element(albedos.begin(), albedos.end());
}

double conserveEnergy(Material& material, int threads)
{
    const double largest = largestAlbedo(material, threads);
    if (!(largest > 1.0)) return 1.0;
    const double factor = kBelowOne / largest;
    for (Vec3f& scale : material.scales) scale *= static_cast<float>(factor);
    return factor;
}

}  // namespace fbrdf

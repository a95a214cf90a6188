#include <fbrdf/base/Assert.h>
#include <fbrdf/environment/EnvironmentTruth.h>

#include <cmath>

namespace fbrdf {

EnvironmentTruth::EnvironmentTruth(const std::vector<Panorama>& panoramas,
                                   const TexelSplits& splits)
    : panoramas_(panoramas), splits_(splits)
{
    FBRDF_ASSERT(panoramas.size(), >=, size_t(1));
    const Panorama& first = panoramas_.front();
    for (int y = 0; y < first.height; ++y)
        for (int x = 0; x < first.width; ++x)
            texels_.push_back({panoramaDirection((x + 0.5) / first.width, (y + 0.5) / first.height),
                               texelSolidAngle(first, y), x, y});
}

std::vector<Vec3d> EnvironmentTruth::reflected(const Reflectance& f,
                                               const ShadingFrame<double>& frame,
                                               const Vec3d& viewer, double leastCosine) const
{
    std::vector<Vec3d> sums(panoramas_.size(), Vec3d(0.0));
    const Vec3d wo = frame.local(viewer);
    const Vec3d mirror = 2.0 * wo.z * frame.n - viewer;
    const double near = std::cos(splits_.nearAngle), nearest = std::cos(splits_.nearestAngle);
    // A texel that the horizon cuts may have its centre below.
    const double lowest = -2.0 * kPi / panoramas_.front().height;
    for (const Texel& texel : texels_) {
        if (glm::dot(texel.direction, frame.n) < lowest) continue;
        const double cosine = glm::dot(texel.direction, mirror);
        const int splits = cosine > nearest ? splits_.nearest
                           : cosine > near  ? splits_.near
                                            : splits_.far;
        const Vec3d mean = meanReflected(f, frame, wo, texel, splits, leastCosine);
        if (mean == Vec3d(0.0)) continue;
        for (size_t k = 0; k < sums.size(); ++k)
            sums[k] += mean * texel.solidAngle * Vec3d(panoramas_[k].texel(texel.x, texel.y));
    }
    return sums;
}

Vec3d EnvironmentTruth::meanReflected(const Reflectance& f, const ShadingFrame<double>& frame,
                                      const Vec3d& wo, const Texel& texel, int splits,
                                      double leastCosine) const
{
    Vec3d sum(0.0);
    double weights = 0.0;
    for (int j = 0; j < splits; ++j) {
        const double v = (texel.y + (j + 0.5) / splits) / panoramas_.front().height;
        // Rows of a texel near a pole differ in length.
        const double weight = std::sin(kPi * v);
        for (int i = 0; i < splits; ++i) {
            weights += weight;
            const double u = (texel.x + (i + 0.5) / splits) / panoramas_.front().width;
            const Vec3d wi = frame.local(splits == 1 ? texel.direction : panoramaDirection(u, v));
            if (wi.z > leastCosine) sum += weight * wi.z * f(wo, wi);
        }
    }
    return sum / weights;
}

}  // namespace fbrdf

// EnvironmentTruth.h - what a surface reflects of an environment, by brute force in double: the sum
// over every texel of the panorama.
#pragma once
#include <fbrdf/brdf/ShadingFrame.h>
#include <fbrdf/environment/Panorama.h>
#include <fbrdf/environment/Reflectance.h>

#include <vector>

namespace fbrdf {

/// Texels are split where the reflectance changes within them: those whose centre is within an
/// angle of the mirror direction of the view into some squared sub-samples.
struct TexelSplits {
    double nearAngle = 20.0 * kDegree, nearestAngle = 5.0 * kDegree;
    int far = 1, near = 4, nearest = 16;  ///< along each side of a texel, >= 1
};

/// Integrates several panoramas of one size at once: the reflectance, which costs most, is
/// evaluated once for all.
class EnvironmentTruth {
public:
    /// Expects valid panoramas of one size, at least one. They are copied.
    explicit EnvironmentTruth(const std::vector<Panorama>& panoramas,
                              const TexelSplits& splits = {});

    /// The radiance that leaves towards `viewer` (unit, world space, above the horizon of the
    /// frame), for each panorama: the integral of f L cos theta_i. Pairs below the horizon add
    /// nothing, nor do those whose cosine theta_i is at most `leastCosine`.
    std::vector<Vec3d> reflected(const Reflectance& f, const ShadingFrame<double>& frame,
                                 const Vec3d& viewer, double leastCosine = 0.0) const;

private:
    struct Texel {
        Vec3d direction;
        double solidAngle;
        int x, y;
    };
    Vec3d meanReflected(const Reflectance& f, const ShadingFrame<double>& frame, const Vec3d& wo,
                        const Texel& texel, int splits, double leastCosine) const;

    std::vector<Panorama> panoramas_;
    TexelSplits splits_;
    std::vector<Texel> texels_;
};

}  // namespace fbrdf

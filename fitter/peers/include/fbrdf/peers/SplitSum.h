// SplitSum.h - the usual approximation of light from environments (Karis 2013, "Real Shading in
// Unreal Engine 4"): one GGX lobe about a bent mirror direction times the albedo of the material,
// and a diffuse term.
#pragma once
#include <fbrdf/metrics/EnvironmentSphere.h>

#include <vector>

namespace fbrdf {

/// Split sums of every width on one scene, integrated exactly, without the errors of a cube.
class SplitSum {
public:
    explicit SplitSum(const EnvironmentSphere& sphere, int threads);

    struct Fit {
        double alpha = 0.0;  ///< roughness squared
        Vec3d diffuse{0.0};
        std::vector<double> psnr;  ///< of each environment
    };
    /// The width and the diffuse albedo that come nearest to the truth in these environments, which
    /// nobody could choose without it. albedo: directional albedo of the material at each pixel.
    Fit best(const std::vector<EnvironmentSphere::Image>& truth,
             const std::vector<Vec3d>& albedo) const;

private:
    const EnvironmentSphere& sphere_;
    std::vector<double> alphas_;
    std::vector<std::vector<EnvironmentSphere::Image>>
        images_;  ///< of a white lobe, for each alpha
};

}  // namespace fbrdf

// GgxFit.h - GGX lobes over a Lambertian, fitted by non-linear least squares (Ceres).
//
//   f = kd / pi + sum over lobes of  s (f0 + (1 - f0) (1 - cos theta_d)^5) D G2 / (4 cos cos)
// with kd and s a colour, f0 a number; D of Walter et al. 2007, height-correlated G2 of Heitz 2014,
// Eq. 99. Minimised is sum |phi(c f) - phi(c g)|^2 with c = cos theta_i and phi = log(1 + 10 x)
// or the cube root: both weigh errors as a rendering shows them (Bieron and Peers 2020 compare such
// metrics). Several starts over the roughness; the best on few samples is refined on all.
#pragma once
#include <fbrdf/fit/Fit.h>

#include <string>
#include <vector>

namespace fbrdf {

struct GgxLobe {
    Vec3d scale{0.0};
    double f0 = 0.0;      ///< in (0, 1)
    double alphaX = 0.0;  ///< roughness along the tangent
    double alphaY = 0.0;  ///< across it
};

struct GgxModel {
    Vec3d kd{0.0};
    std::vector<GgxLobe> lobes;
};

enum class GgxMetric { log1p, cubeRoot };

struct GgxFitOptions {
    int lobes = 1;          ///< 1 or 2
    bool isotropic = true;  ///< alphaX = alphaY
    GgxMetric metric = GgxMetric::cubeRoot;
    int threads = 0;
    FitWatch watch;
};

/// The best fit of all starts. Negative values of samples count as 0. Throws Error(fit) without
/// samples, Error(usage) for another number of lobes, FitStopped where the watch is stopped.
GgxModel fitGgx(const std::vector<Sample>& samples, const GgxFitOptions& options);

/// f(wo, wi); 0 below the horizon.
Vec3d evaluate(const GgxModel& model, const Vec3d& wo, const Vec3d& wi);

/// "kd 0.1/0.2/0.3, lobe alpha 0.12 f0 0.04 scale 1/1/1": one line, for people.
std::string describe(const GgxModel& model);

}  // namespace fbrdf

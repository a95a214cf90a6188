// OrenNayar.h - the full model of rough diffuse surfaces, for the models that use it.
#pragma once
#include "ModelBuild.h"

namespace fbrdf {

/// f in 1/sr. `albedo`: of the facets, [0, 1] per channel; `sigma`: standard deviation of the
/// facets' slope angle, radians.
Vec3d orenNayar(const Vec3d& albedo, double sigma, const Vec3d& wo, const Vec3d& wi);

ModelParameter orenNayarSigma(double initial);

}  // namespace fbrdf

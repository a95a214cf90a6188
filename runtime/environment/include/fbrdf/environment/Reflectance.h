// Reflectance.h - a BRDF as a function.
#pragma once
#include <fbrdf/brdf/Conventions.h>

#include <functional>

namespace fbrdf {

/// f(wo, wi) in 1/sr of unit directions in the local frame, 0 below the horizon. It is called from
/// several threads at once.
using Reflectance = std::function<Vec3d(const Vec3d& wo, const Vec3d& wi)>;

}  // namespace fbrdf

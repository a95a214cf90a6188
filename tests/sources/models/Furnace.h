// Furnace.h - the directional albedo of a BRDF by quadrature: what a surface sends towards wo when
// it is lit with radiance 1 from everywhere.
#pragma once
#include <fbrdf/sources/Model.h>

namespace fbrdf::test {

/// Integral of g over the hemisphere: Gauss-Legendre in u = (theta / (pi/2))^(1/3), which spends
/// its nodes about the normal, and the midpoint rule in phi.
Vec3d integrateHemisphere(const std::function<Vec3d(const Vec3d& direction)>& g);

/// Integral of f(wo, wi) wi.z over the hemisphere of wi, per channel. Integrated over the half
/// vector h, d omega_i = 4 (wo.h) d omega_h, because highlights sit at h = n whatever wo is. Good
/// to kFurnace for lobes of roughness 0.01 and more.
Vec3d directionalAlbedo(const BrdfFunction& f, const Vec3d& wo);

/// Error of the rule, from Lambertians and mirrors of known albedo (FurnaceTest.cpp) and from the
/// horizon, where f cos is cut off in the middle of a cell.
constexpr double kFurnace = 2e-3;

/// The largest channel of the albedo over a fan of directions, normal to 3 degrees from grazing,
/// in and off the planes of symmetry.
double largestAlbedo(const BrdfFunction& f);

/// True when the largest albedo does not exceed 1 by more than the error of the rule.
bool conserves(const BrdfFunction& f);

}  // namespace fbrdf::test

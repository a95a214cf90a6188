// SvdBaseline.h - f as a sum of K signed products, by singular values: seed Eq. 3; Kautz and McCool
// 1999, "Interactive Rendering with Arbitrary BRDFs using Separable Approximations".
//
//   f(wo, wi) ~ sum over k of u_k(h) v_k(d),   h the half vector, d the difference vector
// The function is resampled on a regular grid: a matrix whose rows are half vectors (equal steps of
// sqrt(theta_h), and of phi_h where the source is anisotropic) and whose columns are difference
// vectors (theta_d, phi_d). Its leading singular vectors minimise the absolute error; values may be
// negative. Colour channels are independent. Pairs below the horizon take the value of the last
// theta_h above it. Tables count as 16-bit texels; a term costs two look-ups.
#pragma once
#include <fbrdf/fit/StandardSphere.h>

#include <array>
#include <vector>

namespace fbrdf {

struct SvdGrid {
    int thetaH = 64, phiH = 1, thetaD = 16, phiD = 32;  ///< phiH = 1: isotropic
};

struct SvdModel {
    SvdGrid grid;
    int terms = 0;
    /// Per channel, term after term: u over (phi_h, theta_h contiguous), v over (phi_d, theta_d
    /// contiguous); the singular value is in u.
    std::array<std::vector<float>, 3> u, v;
};

/// Throws Error(usage) unless 1 <= terms <= the smaller side of the matrix.
SvdModel fitSvd(const BrdfFunction& brdf, const SvdGrid& grid, int terms, int threads);

/// Bilinear look-ups; 0 below the horizon; may be negative.
Vec3d evaluate(const SvdModel& model, const Vec3d& wo, const Vec3d& wi);

size_t bytesOf(const SvdModel& model);

}  // namespace fbrdf

// Svd.h - f as a sum of K signed products by singular values (docs/method.md, Eq. 3); Kautz and
// McCool 1999, "Interactive Rendering with Arbitrary BRDFs using Separable Approximations".
//
//   f(wo, wi) ~ sum over k of  s_k u_k(h) v_k(d),   h the half vector, d the difference vector
// The function is resampled on a regular grid: a matrix whose rows are the texels of u (theta_h, or
// a disc of half vectors where the source is anisotropic) and whose columns are those of v (theta_d
// and phi_d, or a disc). Its leading singular vectors minimise the absolute error; values may be
// negative. Pairs below the horizon have no value: they hardly count, see Svd.cpp. Channels are
// independent. Data that a form in logs can follow are better fitted by it: the bytes of this one
// grow with K, and absolute errors show in dark colours.
#pragma once
#include <fbrdf/brdf/Material.h>
#include <fbrdf/metrics/StandardSphere.h>

namespace fbrdf {

/// `terms` products of u and v. `size`: knots of u over theta_h, at least 4; v has a quarter of
/// them over theta_d and an eighth and one over phi_d. Anisotropic: both are discs of half as many
/// texels a side.
Form formSvd(int terms, int size, bool isotropic);
constexpr int kSvdSize = 64;  ///< the usual one

constexpr int kMaxSvdTerms = 32;  ///< a form has at most 64 tables

/// The table that a function of scattered samples is resampled by: V(theta_h, theta_d, phi_d) over
/// the knots of an isotropic formSvd.
Form formSvdGrid(int size);

/// `form` as formSvd makes it, its tables signed half floats scaled to a largest magnitude of 1.
/// Throws Error(usage) unless it has 1 to kMaxSvdTerms terms, and no
/// more than the matrix has rows and columns.
Material svdMaterial(const BrdfFunction& brdf, const Form& form, int threads);

}  // namespace fbrdf

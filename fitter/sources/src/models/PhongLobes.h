// PhongLobes.h - the normalised lobes of Phong and Blinn, and the parameters they share.
#pragma once
#include "ModelBuild.h"

namespace fbrdf {

/// (n + 2) / (2 pi): makes the albedo of (r.wo)^n at normal incidence 1.
/// Lafortune and Willems 1994, Using the Modified Phong Reflectance Model, section 3.
double phongNormalisation(double n);

/// (n + 2) (n + 4) / (8 pi (n + 2^(-n/2))): the same for (n.h)^n. Derived in the source.
double blinnPhongNormalisation(double n);

/// kd, ks, n.
std::vector<ModelParameter> phongParameters();

}  // namespace fbrdf

// PriorMatrix.h - the dense matrices of priors.
#pragma once
#include <Eigen/Core>

namespace fbrdf {

using PriorMatrix = Eigen::MatrixXd;
using PriorVector = Eigen::VectorXd;

}  // namespace fbrdf

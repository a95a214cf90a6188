#include "Solver.h"

#include <Eigen/Cholesky>

namespace fbrdf {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;

// The row-major lower triangle is the column-major upper one: Eigen factors it in place as U^T U.
Cholesky::Cholesky(const SymmetricMatrix& matrix) : size_(matrix.size), factor_(matrix.lower)
{
    const auto n = static_cast<Eigen::Index>(size_);
    Eigen::Map<Matrix> map(factor_.data(), n, n);
    map.triangularView<Eigen::StrictlyLower>() = map.transpose();
    Eigen::Ref<Matrix> reference(map);
    const Eigen::LLT<Eigen::Ref<Matrix>> llt(reference);
    ok_ = llt.info() == Eigen::Success;
}

void Cholesky::solve(double* values, size_t columns) const
{
    const auto n = static_cast<Eigen::Index>(size_);
    const Eigen::Map<const Matrix> factor(factor_.data(), n, n);
    Eigen::Map<Matrix> x(values, n, static_cast<Eigen::Index>(columns));
    factor.triangularView<Eigen::Lower>().solveInPlace(x);
    factor.triangularView<Eigen::Lower>().transpose().solveInPlace(x);
}

}  // namespace fbrdf

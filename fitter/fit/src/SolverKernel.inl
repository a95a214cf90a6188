// Included by SolverBaseline.cpp and SolverAvx2.cpp with FBRDF_FACTOR and FBRDF_SOLVE naming the
// functions, and Eigen renamed, so that the two compilations share no symbol.
#include <Eigen/Cholesky>

namespace fbrdf {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;

bool FBRDF_FACTOR(double* matrix, std::ptrdiff_t n)
{
    Eigen::Map<Matrix> map(matrix, n, n);
    Eigen::Ref<Matrix> reference(map);
    return Eigen::LLT<Eigen::Ref<Matrix>>(reference).info() == Eigen::Success;
}

void FBRDF_SOLVE(const double* factor, std::ptrdiff_t n, double* values, std::ptrdiff_t columns)
{
    const Eigen::Map<const Matrix> map(factor, n, n);
    Eigen::Map<Matrix> x(values, n, columns);
    map.triangularView<Eigen::Lower>().solveInPlace(x);
    map.triangularView<Eigen::Lower>().transpose().solveInPlace(x);
}

}  // namespace fbrdf

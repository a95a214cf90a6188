#include "solve/Solver.h"

#include <fbrdf/base/Assert.h>

#include "solve/SolverKernel.h"

#include <cmath>

namespace fbrdf {
namespace {

struct Kernels {
    FactorKernel factor;
    SolveKernel solve;
};

Kernels kernelsOfThisMachine()
{
#ifdef FBRDF_HAVE_AVX2_KERNELS
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return {factorAvx2, solveAvx2};
#endif
    return {factorBaseline, solveBaseline};
}

BorderedParts partsOf(const BorderedMatrix& matrix)
{
    const BorderedShape& shape = matrix.shape;
    auto* values = const_cast<double*>(matrix.values.data());
    double* border = values + shape.bandSize();
    return {values,
            border,
            border + shape.borderSize(),
            static_cast<std::ptrdiff_t>(shape.banded),
            static_cast<std::ptrdiff_t>(shape.bandwidth),
            static_cast<std::ptrdiff_t>(shape.dense)};
}

}  // namespace

Cholesky::Cholesky(BorderedMatrix matrix) : factor_(std::move(matrix))
{
    ok_ = kernelsOfThisMachine().factor(partsOf(factor_));
}

void Cholesky::solve(double* values, size_t columns) const
{
    FBRDF_ASSERT(ok_, ==, true);
    kernelsOfThisMachine().solve(partsOf(factor_), values, static_cast<std::ptrdiff_t>(columns));
}

double Cholesky::logDeterminant() const
{
    FBRDF_ASSERT(ok_, ==, true);
    double sum = 0.0;
    for (size_t u = 0; u < factor_.shape.unknowns(); ++u) sum += std::log(factor_.at(u, u));
    return 2.0 * sum;
}

}  // namespace fbrdf

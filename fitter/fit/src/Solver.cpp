#include "Solver.h"

#include "SolverKernel.h"

#include <algorithm>

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

// The kernels read the lower triangle of a column-major matrix, which is the upper one of ours:
// mirror it, in tiles that fit the cache.
void mirror(std::vector<double>& matrix, size_t n)
{
    constexpr size_t kTile = 32;
    for (size_t rowTile = 0; rowTile < n; rowTile += kTile)
        for (size_t columnTile = 0; columnTile <= rowTile; columnTile += kTile)
            for (size_t r = rowTile; r < std::min(n, rowTile + kTile); ++r)
                for (size_t c = columnTile; c < std::min(r, columnTile + kTile); ++c)
                    matrix[c * n + r] = matrix[r * n + c];
}

}  // namespace

Cholesky::Cholesky(SymmetricMatrix matrix) : size_(matrix.size), factor_(std::move(matrix.lower))
{
    mirror(factor_, size_);
    ok_ = kernelsOfThisMachine().factor(factor_.data(), static_cast<std::ptrdiff_t>(size_));
}

void Cholesky::solve(double* values, size_t columns) const
{
    kernelsOfThisMachine().solve(factor_.data(), static_cast<std::ptrdiff_t>(size_), values,
                                 static_cast<std::ptrdiff_t>(columns));
}

}  // namespace fbrdf

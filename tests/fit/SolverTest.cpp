#include "Solver.h"

#include "SolverKernel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

// A well-conditioned matrix of 300 unknowns loses at most n eps.
constexpr double kTight = 1e-12;

SymmetricMatrix decaying(size_t n)
{
    SymmetricMatrix m(n);
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j <= i; ++j)
            m.at(i, j) = i == j ? 4.0 : 1.0 / double(1 + (i - j) * (i - j));
    return m;
}

double residualOf(const SymmetricMatrix& m, const std::vector<double>& x,
                  const std::vector<double>& b)
{
    double largest = 0.0;
    for (size_t i = 0; i < m.size; ++i) {
        double sum = -b[i];
        for (size_t j = 0; j < m.size; ++j) sum += (j <= i ? m.at(i, j) : m.at(j, i)) * x[j];
        largest = std::max(largest, std::abs(sum));
    }
    return largest;
}

TEST(Cholesky, SolvesSeveralRightHandSides)
{
    const SymmetricMatrix m = decaying(300);
    std::vector<double> right(2 * 300);
    for (size_t i = 0; i < right.size(); ++i) right[i] = std::sin(double(i));
    std::vector<double> x = right;
    const Cholesky cholesky(m);
    ASSERT_TRUE(cholesky.ok());
    cholesky.solve(x.data(), 2);
    for (size_t c = 0; c < 2; ++c) {
        const auto from = std::ptrdiff_t(c * 300), to = std::ptrdiff_t((c + 1) * 300);
        EXPECT_LT(residualOf(m, {x.begin() + from, x.begin() + to},
                             {right.begin() + from, right.begin() + to}),
                  kTight);
    }
}

TEST(Cholesky, RefusesAnIndefiniteMatrix)
{
    SymmetricMatrix m = decaying(8);
    m.at(5, 5) = -1.0;
    EXPECT_FALSE(Cholesky(m).ok());
}

#ifdef FBRDF_HAVE_AVX2_KERNELS
TEST(Cholesky, BothKernelsAgree)
{
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
        GTEST_SKIP() << "this processor has no AVX2 and FMA";
    constexpr std::ptrdiff_t n = 257;
    const SymmetricMatrix m = decaying(size_t(n));
    std::vector<double> a = m.lower;
    for (std::ptrdiff_t i = 0; i < n; ++i)
        for (std::ptrdiff_t j = 0; j < i; ++j) a[size_t(j * n + i)] = a[size_t(i * n + j)];
    std::vector<double> b = a, x(size_t(n), 1.0), y(size_t(n), 1.0);
    ASSERT_TRUE(factorBaseline(a.data(), n));
    ASSERT_TRUE(factorAvx2(b.data(), n));
    solveBaseline(a.data(), n, x.data(), 1);
    solveAvx2(b.data(), n, y.data(), 1);
    for (size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], y[i], kTight) << i;
}
#endif

}  // namespace
}  // namespace fbrdf

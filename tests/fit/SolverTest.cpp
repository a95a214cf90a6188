#include "solve/Solver.h"

#include "solve/SolverKernel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

// A well-conditioned matrix of 300 unknowns loses at most n eps.
constexpr double kTight = 1e-12;

bool isStored(const BorderedShape& shape, size_t row, size_t column)
{
    return row >= shape.banded || row - column <= shape.bandwidth;
}

BorderedMatrix decaying(const BorderedShape& shape)
{
    BorderedMatrix m(shape);
    for (size_t i = 0; i < shape.unknowns(); ++i)
        for (size_t j = 0; j <= i; ++j)
            if (isStored(shape, i, j))
                m.at(i, j) = i == j ? 4.0 : 1.0 / double(1 + (i - j) * (i - j));
    return m;
}

double residualOf(const BorderedMatrix& m, const double* x, const double* b)
{
    double largest = 0.0;
    const size_t n = m.shape.unknowns();
    for (size_t i = 0; i < n; ++i) {
        double sum = -b[i];
        for (size_t j = 0; j < n; ++j)
            if (isStored(m.shape, std::max(i, j), std::min(i, j)))
                sum += m.at(std::max(i, j), std::min(i, j)) * x[j];
        largest = std::max(largest, std::abs(sum));
    }
    return largest;
}

// Dense alone, banded alone, both, a diagonal band, a band as wide as the block.
class CholeskyOf : public testing::TestWithParam<BorderedShape> {};

TEST_P(CholeskyOf, SolvesSeveralRightHandSides)
{
    const BorderedMatrix m = decaying(GetParam());
    const size_t n = m.shape.unknowns();
    std::vector<double> right(2 * n);
    for (size_t i = 0; i < right.size(); ++i) right[i] = std::sin(double(i));
    std::vector<double> x = right;
    const Cholesky cholesky(m);
    ASSERT_TRUE(cholesky.ok());
    cholesky.solve(x.data(), 2);
    for (size_t c = 0; c < 2; ++c) EXPECT_LT(residualOf(m, &x[c * n], &right[c * n]), kTight);
    x[0] += 1e-6;  // the tester itself
    EXPECT_GT(residualOf(m, x.data(), right.data()), kTight);
}

// A row and its column scaled by s scale the determinant by s^2.
TEST_P(CholeskyOf, HasADeterminant)
{
    const BorderedMatrix m = decaying(GetParam());
    const size_t n = m.shape.unknowns();
    BorderedMatrix scaled = m, diagonal(m.shape);
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j <= i; ++j)
            if (isStored(m.shape, i, j)) scaled.at(i, j) *= (1.0 + double(i)) * (1.0 + double(j));
    double logs = 0.0;
    for (size_t i = 0; i < n; ++i) {
        logs += 2.0 * std::log(1.0 + double(i));
        diagonal.at(i, i) = (1.0 + double(i)) * (1.0 + double(i));
    }
    EXPECT_NEAR(Cholesky(diagonal).logDeterminant(), logs, 1e-12 * logs);
    EXPECT_NEAR(Cholesky(scaled).logDeterminant() - Cholesky(m).logDeterminant(), logs,
                1e-12 * logs);
}

TEST_P(CholeskyOf, RefusesAnIndefiniteMatrix)
{
    for (const size_t u : {size_t{0}, GetParam().unknowns() / 2, GetParam().unknowns() - 1}) {
        BorderedMatrix m = decaying(GetParam());
        m.at(u, u) = -1.0;
        EXPECT_FALSE(Cholesky(m).ok()) << u;
        m.at(u, u) = std::nan("");
        EXPECT_FALSE(Cholesky(m).ok()) << u;
    }
}

#ifdef FBRDF_HAVE_AVX2_KERNELS
BorderedParts partsOf(BorderedMatrix& m)
{
    double* values = m.values.data();
    return {values,
            values + m.shape.bandSize(),
            values + m.shape.bandSize() + m.shape.borderSize(),
            std::ptrdiff_t(m.shape.banded),
            std::ptrdiff_t(m.shape.bandwidth),
            std::ptrdiff_t(m.shape.dense)};
}

TEST_P(CholeskyOf, BothKernelsAgree)
{
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
        GTEST_SKIP() << "this processor has no AVX2 and FMA";
    BorderedMatrix a = decaying(GetParam()), b = a;
    std::vector<double> x(a.shape.unknowns(), 1.0), y = x;
    ASSERT_TRUE(factorBaseline(partsOf(a)));
    ASSERT_TRUE(factorAvx2(partsOf(b)));
    solveBaseline(partsOf(a), x.data(), 1);
    solveAvx2(partsOf(b), y.data(), 1);
    for (size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], y[i], kTight) << i;
}
#endif

INSTANTIATE_TEST_SUITE_P(Shapes, CholeskyOf,
                         testing::Values(BorderedShape{0, 0, 257}, BorderedShape{201, 13, 0},
                                         BorderedShape{150, 21, 83}, BorderedShape{40, 0, 9},
                                         BorderedShape{33, 32, 34}));

}  // namespace
}  // namespace fbrdf

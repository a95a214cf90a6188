// The kernels for every x86-64 and those for AVX2 against loops in double.
#include "solve/RowKernel.h"
#include "solve/Solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace fbrdf {
namespace {

constexpr std::ptrdiff_t kRows = 64, kWidth = 6, kUnknowns = 10, kBanded = 6, kBandwidth = 5;
constexpr size_t kLanes = kRowLanes;

struct Set {
    const char* name;
    RowKernels kernels;
};

std::vector<Set> kernelSets()
{
    std::vector<Set> sets{{"baseline", kRowKernelsBaseline}};
#ifdef FBRDF_HAVE_AVX2_KERNELS
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        sets.push_back({"avx2", kRowKernelsAvx2});
#endif
    return sets;
}

/// Rows of one term: three entries of banded unknowns, then three of the others.
struct Block {
    std::vector<int> unknown;
    std::vector<float> weight, sampleWeight, residual;
    std::vector<unsigned char> group;
    int termEnd = kWidth;

    Block()
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> number(0.1f, 1.0f);
        for (int i = 0; i < kRows; ++i) {
            for (int k = 0; k < kWidth; ++k) {
                unknown.push_back(k < 3 ? (i + 2 * k) % 6 : 6 + (i + k) % 4);
                weight.push_back(number(random));
            }
            group.push_back(i % 9 == 0 ? kNoGroup : static_cast<unsigned char>(i % 2));
            for (size_t lane = 0; lane < kLanes; ++lane) {
                sampleWeight.push_back(number(random));
                residual.push_back(number(random) - 0.5f);
            }
        }
    }

    KernelRows rows() const
    {
        return {kRows, kWidth, unknown.data(),      weight.data(),   nullptr,     &termEnd, 1,
                0,     3,      sampleWeight.data(), residual.data(), group.data()};
    }
    bool counts(size_t row) const { return group[row] != kNoGroup; }
    size_t unknownOf(size_t row, size_t k) const
    {
        return static_cast<size_t>(unknown[row * kWidth + k]);
    }
    double entry(size_t row, size_t k) const { return double(weight[row * kWidth + k]); }
    double weightOf(size_t row, size_t lane) const
    {
        return double(sampleWeight[row * kLanes + lane]);
    }
    double residualOf(size_t row, size_t lane) const
    {
        return double(residual[row * kLanes + lane]);
    }
};

void expectNear(const std::vector<double>& found, const std::vector<double>& expected,
                const char* name)
{
    ASSERT_EQ(found.size(), expected.size());
    for (size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-12 * (1.0 + std::abs(expected[i])))
            << name << " at " << i;
}

// Against libm: the precision of a float for logarithms up to 126, and of numbers near 1.
TEST(RowKernels, LogarithmsAndPredictionsAreThoseOfLibm)
{
    constexpr float kUlps = 3e-7f;
    std::vector<float> numbers;
    for (float x = 1.2e-38f; x < 1e38f; x *= 1.37f) numbers.push_back(x);
    for (int i = -50; i <= 50; ++i) numbers.push_back(1.0f + 1e-3f * float(i));
    for (const Set& set : kernelSets()) {
        std::vector<float> logs = numbers;
        set.kernels.log2(logs.data(), std::ptrdiff_t(logs.size()));
        for (size_t i = 0; i < logs.size(); ++i)
            EXPECT_NEAR(logs[i], std::log2(numbers[i]), kUlps * std::max(1.0f, std::abs(logs[i])))
                << set.name << " of " << numbers[i];
        const int unknown[2] = {0, 1}, termEnd[2] = {1, 2};
        const float weight[2] = {1.0f, 1.0f}, levels[8] = {};
        KernelRows row{};
        row.count = 1;
        row.width = row.terms = 2;
        row.unknown = unknown;
        row.weight = weight;
        row.termEnd = termEnd;
        for (float x = -40.0f; x < 40.0f; x += 0.37f) {
            const float texels[8] = {x, -x, x / 7, 0.0f, 1.0f, 0.5f, x / 3, 0.0f};
            float logG[4], share[8];
            set.kernels.predict(row, {texels, levels}, logG, share);
            for (size_t l = 0; l < 4; ++l) {
                const double a = std::exp2(double(texels[l])), b = std::exp2(double(texels[4 + l]));
                EXPECT_NEAR(logG[l], std::log2(a + b), 4e-6) << set.name << " at " << x;
                EXPECT_NEAR(share[l], a / (a + b), kUlps * 4) << set.name << " at " << x;
            }
        }
    }
}

TEST(RowKernels, AddUpNormalEquationsByGroups)
{
    const Block block;
    const BorderedShape shape{kBanded, kBandwidth, kUnknowns - kBanded};
    for (const Set& set : kernelSets()) {
        std::vector<double> matrix[2], right[2], exactRight[2];
        BorderedMatrix exact[2] = {BorderedMatrix(shape), BorderedMatrix(shape)};
        for (int g = 0; g < 2; ++g) {
            matrix[g].assign(shape.size(), 0.0);
            right[g].assign(kUnknowns * kLanes, 0.0);
            exactRight[g] = right[g];
        }
        double *const matrices[] = {matrix[0].data(), matrix[1].data()}, *const rights[] = {
                                                                             right[0].data(),
                                                                             right[1].data()};
        std::vector<double> scratch(kWidth * kLanes);
        set.kernels.add(block.rows(), {kBanded, kBandwidth, kUnknowns - kBanded, matrices, rights},
                        1, 1, scratch.data());
        for (size_t i = 0; i < kRows; ++i) {
            if (!block.counts(i)) continue;
            const size_t g = block.group[i];
            for (size_t a = 0; a < kWidth; ++a) {
                const size_t u = block.unknownOf(i, a);
                for (size_t lane = 0; lane < kLanes; ++lane)
                    exactRight[g][u * kLanes + lane] +=
                        block.weightOf(i, lane) * block.entry(i, a) * block.residualOf(i, lane);
                for (size_t b = 0; b < kWidth; ++b)
                    if (const size_t v = block.unknownOf(i, b); v <= u)
                        exact[g].at(u, v) +=
                            block.weightOf(i, 0) * block.entry(i, a) * block.entry(i, b);
            }
        }
        for (int g = 0; g < 2; ++g) {
            expectNear(right[g], exactRight[g], set.name);
            const SystemNumbers& values = exact[g].values;
            expectNear(matrix[g], {values.begin(), values.end()}, set.name);
        }
    }
}

TEST(RowKernels, ApplyTheMatrixAndItsDiagonal)
{
    const Block block;
    std::vector<double> p;
    for (size_t i = 0; i < kUnknowns * kLanes; ++i) p.push_back(0.1 * static_cast<double>(i) - 1.0);
    for (const Set& set : kernelSets()) {
        std::vector<double> result(p.size(), 0.0), exact = result, squares = result,
                                                   exactSquares = result, rights = result,
                                                   exactRights = result;
        std::vector<double> scratch(kWidth * kLanes);
        double* const sums[] = {squares.data(), rights.data()};
        set.kernels.apply(block.rows(), 1, p.data(), result.data(), scratch.data());
        set.kernels.diagonal(block.rows(), 1, sums, scratch.data());
        for (size_t i = 0; i < kRows; ++i)
            for (size_t lane = 0; block.counts(i) && lane < kLanes; ++lane) {
                double along = 0.0;
                for (size_t k = 0; k < kWidth; ++k)
                    along += block.entry(i, k) * p[block.unknownOf(i, k) * kLanes + lane];
                for (size_t k = 0; k < kWidth; ++k) {
                    const size_t at = block.unknownOf(i, k) * kLanes + lane;
                    const double b = block.entry(i, k), w = block.weightOf(i, lane);
                    exact[at] += w * b * along;
                    exactSquares[at] += w * b * b;
                    exactRights[at] += w * b * block.residualOf(i, lane);
                }
            }
        expectNear(result, exact, set.name);
        expectNear(squares, exactSquares, set.name);
        expectNear(rights, exactRights, set.name);
    }
}

// Numbers that start `shift` numbers behind a boundary of 32 bytes.
struct Shifted {
    std::vector<double> numbers;
    size_t first = 0;

    Shifted(size_t count, size_t shift, double value) : numbers(count + 8, value)
    {
        while (reinterpret_cast<uintptr_t>(&numbers[first]) % 32 != 0) ++first;
        first += shift;
    }
    double* data() { return &numbers[first]; }
};

// Instructions that ask for 32 bytes fault at the arrays of a standard container.
TEST(RowKernels, NeedNoMoreAlignmentThanNumbers)
{
    const Block block;
    const BorderedShape shape{kBanded, kBandwidth, kUnknowns - kBanded};
    std::vector<float> share(kRows * kLanes, 1.0f), logG(kRows * kLanes + 8);
    const std::vector<float> texels(kUnknowns * kLanes + 8, 0.5f), levels(kLanes + 8, 0.0f);
    for (const Set& set : kernelSets())
        for (const int entryLanes : {1, int(kLanes)})
            for (size_t shift = 0; shift < 4; ++shift) {
                KernelRows rows = block.rows();
                if (entryLanes > 1) rows.share = share.data();
                Shifted matrix(shape.size() * kLanes, shift, 0.0),
                    p(kUnknowns * kLanes, shift, 1.0), first(kUnknowns * kLanes, shift, 0.0),
                    second(kUnknowns * kLanes, shift, 0.0), scratch(kWidth * kLanes, shift, 0.0);
                double *const matrices[] = {matrix.data(), matrix.data()},
                              *const rights[] = {first.data(), first.data()},
                              *const both[] = {first.data(), second.data()};
                set.kernels.add(rows, {kBanded, kBandwidth, kUnknowns - kBanded, matrices, rights},
                                entryLanes, int(kLanes), scratch.data());
                set.kernels.apply(rows, entryLanes, p.data(), second.data(), scratch.data());
                set.kernels.diagonal(rows, entryLanes, both, scratch.data());
                EXPECT_GT(
                    std::accumulate(matrix.data(), matrix.data() + shape.size() * kLanes, 0.0), 0.0)
                    << set.name;
                EXPECT_GT(*second.data(), 0.0) << set.name;
                set.kernels.predict(block.rows(), {&texels[shift], &levels[shift]}, &logG[shift],
                                    nullptr);
                EXPECT_NE(logG[shift], 0.0f) << set.name;
                set.kernels.log2(&logG[shift], kRows);
            }
}

}  // namespace
}  // namespace fbrdf

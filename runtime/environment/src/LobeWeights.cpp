#include "LobeWeights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace fbrdf {
namespace {

constexpr int kSweeps = 12;
// Relative to the diagonal: two lobes of the dictionary that are nearly one have no weights of
// their own.
constexpr double kRidge = 1e-5;

/// The unknowns of a set, and the multiplier of the constraint.
using System = std::array<std::array<double, kMostWeights + 2>, kMostWeights + 1>;

/// Solves the first `count` rows, whose last column is the right side, by elimination with pivots.
bool solve(System& a, int count)
{
    const auto n = static_cast<size_t>(count);
    for (size_t k = 0; k < n; ++k) {
        size_t pivot = k;
        for (size_t i = k + 1; i < n; ++i)
            if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
        if (!(std::abs(a[pivot][k]) > 0.0)) return false;
        std::swap(a[k], a[pivot]);
        for (size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const double factor = a[i][k] / a[k][k];
            for (size_t j = k; j <= n; ++j) a[i][j] -= factor * a[k][j];
        }
    }
    for (size_t k = 0; k < n; ++k) a[k][n] /= a[k][k];
    return true;
}

/// The weights of a set (bits) that add up to sum, or nothing where one is negative.
std::optional<Weights> weightsOfSet(const WeightProblem& p, unsigned set, double sum)
{
    std::array<size_t, kMostWeights> members{};
    size_t n = 0;
    for (size_t i = 0; i < static_cast<size_t>(p.count); ++i)
        if (set >> i & 1u) members[n++] = i;
    System a{};
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) a[i][j] = p.gram[members[i]][members[j]];
        a[i][i] *= 1.0 + kRidge * 1e-4;
        a[i][n] = a[n][i] = 1.0;
        a[i][n + 1] = p.right[members[i]];
    }
    a[n][n + 1] = sum;
    if (!solve(a, static_cast<int>(n) + 1)) return std::nullopt;
    Weights weights{};
    for (size_t i = 0; i < n; ++i) {
        if (!(a[i][n + 1] >= 0.0)) return std::nullopt;
        weights[members[i]] = a[i][n + 1];
    }
    return weights;
}

}  // namespace

double objective(const WeightProblem& p, const Weights& w)
{
    double value = 0.0;
    for (size_t i = 0; i < static_cast<size_t>(p.count); ++i) {
        double row = 0.0;
        for (size_t j = 0; j < static_cast<size_t>(p.count); ++j) row += p.gram[i][j] * w[j];
        value += w[i] * (row - 2.0 * p.right[i]);
    }
    return value;
}

Weights roughWeights(const WeightProblem& p)
{
    // Coordinate descent from the solution of the whole system, cut off at 0.
    Weights w{};
    const auto n = static_cast<size_t>(p.count);
    System a{};
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < n; ++j) a[i][j] = p.gram[i][j];
        a[i][i] += kRidge * p.gram[0][0];
        a[i][n] = p.right[i];
    }
    bool isPositive = solve(a, p.count);
    if (isPositive)
        for (size_t i = 0; i < n; ++i) {
            isPositive = isPositive && a[i][n] >= 0.0;
            w[i] = std::max(0.0, a[i][n]);
        }
    if (isPositive) return w;
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        for (size_t i = 0; i < n; ++i) {
            double residual = p.right[i];
            for (size_t j = 0; j < n; ++j) residual -= p.gram[i][j] * w[j];
            w[i] = std::max(0.0, w[i] + residual / p.gram[i][i]);
        }
    return w;
}

Weights weightsOfSum(const WeightProblem& p, double sum)
{
    Weights best{};
    double least = std::numeric_limits<double>::infinity();
    for (unsigned set = 1; set < 1u << p.count; ++set) {
        const auto weights = weightsOfSet(p, set, sum);
        if (!weights) continue;
        const double value = objective(p, *weights);
        if (value < least) {
            least = value;
            best = *weights;
        }
    }
    return best;
}

}  // namespace fbrdf

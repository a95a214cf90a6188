#include "prior/PriorSystem.h"

#include "prior/PriorSample.h"
#include "solve/NormalSystem.h"

#include <fbrdf/base/Assert.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

using Index = Eigen::Index;
using ModeRow = Eigen::RowVectorXd;

float valueOf(const RowStore::Block& block, size_t i, int c)
{
    return std::exp2(block.values.logValue[i][c]);
}

double weightOf(const RowStore::Block& block, size_t i)
{
    double mean = 0.0, sample = 0.0;
    for (int c = 0; c < 3; ++c) {
        const bool isCensored = (block.values.censored[i] >> c & 1) != 0;
        mean += isCensored ? 0.0 : static_cast<double>(valueOf(block, i, c)) / 3.0;
        sample = std::max(sample, static_cast<double>(block.values.weight[i][c]));
    }
    return sample * weightOfPriorSample(mean);
}

}  // namespace

PriorSystem::PriorSystem(const LeastSquares& problem, const PriorCovariance& prior,
                         int excludedFold)
    : prior_(prior),
      tables_(prior.precision.shape),
      tablesByModes_(PriorMatrix::Zero(prior.modes.rows(), prior.modes.cols())),
      modes_(PriorMatrix::Zero(prior.modes.cols(), prior.modes.cols())),
      right_(PriorMatrix::Zero(prior.modes.rows(), 3))
{
    FBRDF_ASSERT(problem.unknowns(), ==, tables_.shape.unknowns());
    RowStore::Scratch scratch;
    for (size_t b = 0; b < problem.store().blocks(); ++b) {
        const RowStore::Block block = problem.store().block(b, scratch);
        for (size_t i = 0; i < block.geometry.count; ++i)
            if (excludedFold == kNoFold ||
                foldOf(block.geometry.number(i), problem.seed()) != excludedFold)
                add(problem, block, i);
    }
}

void PriorSystem::add(const LeastSquares& problem, const RowStore::Block& block, size_t i)
{
    const auto width = static_cast<size_t>(problem.maker().width());
    const int* unknown = &block.geometry.unknown[i * width];
    const float* entry = &block.geometry.weight[i * width];
    const double weight = weightOf(block, i);
    ModeRow inModes = ModeRow::Zero(modes_.cols());
    double mean = 0.0;
    for (size_t k = 0; k < width; ++k) {
        inModes += static_cast<double>(entry[k]) * prior_.modes.row(unknown[k]);
        mean += static_cast<double>(entry[k]) * prior_.mean(unknown[k]);
    }
    Eigen::RowVector3d residual;
    for (int c = 0; c < 3; ++c)
        residual(c) = log2OfPriorSample(static_cast<double>(valueOf(block, i, c))) - mean;
    for (size_t a = 0; a < width; ++a) {
        const double share = weight * static_cast<double>(entry[a]);
        tablesByModes_.row(unknown[a]) += share * inModes;
        right_.row(unknown[a]) += share * residual;
        for (size_t b = 0; b < width; ++b)
            if (unknown[b] <= unknown[a])
                tables_.at(static_cast<size_t>(unknown[a]), static_cast<size_t>(unknown[b])) +=
                    share * static_cast<double>(entry[b]);
    }
    modes_.noalias() += weight * inModes.transpose() * inModes;
    squares_ += weight * residual.squaredNorm();
    count_ += 1.0;
}

// Of (e, z): [A^T W A / s^2 + S^-1 / tau^2, A^T W A U / s^2; its transpose, U^T A^T W A U / s^2 +
// I].
BorderedMatrix PriorSystem::matrix(const PriorWeights& weights) const
{
    const BorderedShape& tables = tables_.shape;
    const auto modes = static_cast<size_t>(modes_.cols());
    const double data = 1.0 / (weights.noise * weights.noise),
                 smooth = 1.0 / (weights.tau * weights.tau);
    BorderedMatrix result({tables.banded, tables.bandwidth, tables.dense + modes});
    const auto place = [&](size_t row, size_t column) {
        result.at(row, column) =
            data * tables_.at(row, column) + smooth * prior_.precision.at(row, column);
    };
    for (size_t row = 0; row < tables.unknowns(); ++row) {
        const bool isBanded = row < tables.banded;
        const size_t first = isBanded ? row - std::min(row, tables.bandwidth) : 0;
        for (size_t column = first; column <= row; ++column) place(row, column);
    }
    for (size_t k = 0; k < modes; ++k) {
        const size_t row = tables.unknowns() + k;
        const auto mode = static_cast<Index>(k);
        for (size_t column = 0; column < tables.unknowns(); ++column)
            result.at(row, column) = data * tablesByModes_(static_cast<Index>(column), mode);
        for (size_t other = 0; other <= k; ++other)
            result.at(row, tables.unknowns() + other) =
                data * modes_(mode, static_cast<Index>(other)) + (other == k ? 1.0 : 0.0);
    }
    return result;
}

PriorSystem::Posterior PriorSystem::posterior(const PriorWeights& weights) const
{
    const double data = 1.0 / (weights.noise * weights.noise);
    const Index unknowns = right_.rows(), modes = modes_.cols();
    PriorMatrix right(unknowns + modes, 3);
    right << data * right_, data * (prior_.modes.transpose() * right_);
    PriorMatrix solution = right;
    const Cholesky cholesky(matrix(weights));
    Posterior posterior;
    posterior.evidence = -std::numeric_limits<double>::infinity();
    if (!cholesky.ok()) return posterior;
    cholesky.solve(solution.data(), 3);
    // The determinant of the covariance of r, by that of the precision of (e, z) given r.
    const double logDeterminant = cholesky.logDeterminant() - count_ * std::log(data) +
                                  2.0 * static_cast<double>(unknowns) * std::log(weights.tau);
    const double misfit = data * squares_ - right.cwiseProduct(solution).sum();
    posterior.evidence = -0.5 * (misfit + 3.0 * logDeterminant);
    posterior.e = solution.topRows(unknowns);
    posterior.z = solution.bottomRows(modes);
    return posterior;
}

}  // namespace fbrdf

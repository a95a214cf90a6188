#include "prior/PriorCovariance.h"

#include "prior/TableNumbers.h"
#include "solve/NormalSystem.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr double kFirstOrder = 0.1, kLevel = 1e-3;

// The mean of the diagonal of the inverse.
double meanVariance(const Cholesky& cholesky, size_t unknowns)
{
    constexpr size_t kColumns = 32;
    double sum = 0.0;
    for (size_t first = 0; first < unknowns; first += kColumns) {
        const size_t columns = std::min(kColumns, unknowns - first);
        std::vector<double> inverse(unknowns * columns, 0.0);
        for (size_t c = 0; c < columns; ++c) inverse[c * unknowns + first + c] = 1.0;
        cholesky.solve(inverse.data(), columns);
        for (size_t c = 0; c < columns; ++c) sum += inverse[c * unknowns + first + c];
    }
    return sum / static_cast<double>(unknowns);
}

BorderedMatrix smoothnessPrecision(const Form& form, const Layout& layout)
{
    BorderedMatrix precision(shapeOf(layout));
    const size_t unknowns = precision.shape.unknowns();
    for (const SmoothnessRow& row : smoothnessRows(form, layout, kFirstOrder))
        for (int a = 0; a < row.count; ++a)
            for (int b = 0; b < row.count; ++b)
                if (row.unknown[b] <= row.unknown[a])
                    precision.at(static_cast<size_t>(row.unknown[a]),
                                 static_cast<size_t>(row.unknown[b])) +=
                        row.weight[a] * row.weight[b];
    for (size_t u = 0; u < unknowns; ++u) precision.at(u, u) += kLevel;
    const double variance = meanVariance(Cholesky(precision), unknowns);
    for (double& value : precision.values) value *= variance;
    return precision;
}

}  // namespace

PriorMatrix roughness(const Form& form, const Layout& layout)
{
    PriorMatrix sum = PriorMatrix::Zero(layout.unknowns(), layout.unknowns());
    for (const SmoothnessRow& row : smoothnessRows(form, layout, kFirstOrder))
        for (int a = 0; a < row.count; ++a)
            for (int b = 0; b < row.count; ++b)
                sum(row.unknown[a], row.unknown[b]) += row.weight[a] * row.weight[b];
    return sum;
}

PriorMatrix smoothnessRoot(const Form& form)
{
    const Layout layout(form);
    const Eigen::Index n = layout.unknowns();
    const PriorMatrix precision = roughness(form, layout) + kLevel * PriorMatrix::Identity(n, n);
    PriorMatrix root = PriorMatrix::Identity(n, n);
    const Eigen::LLT<PriorMatrix> cholesky(precision);
    cholesky.matrixL().solveInPlace(root);
    return root / std::sqrt(root.squaredNorm() /
                            static_cast<double>(n));  // the mean variance is |root|^2 / n
}

PriorCovariance::PriorCovariance(const TablePrior& prior)
    : form(prior.form), precision(smoothnessPrecision(prior.form, Layout(prior.form)))
{
    const std::vector<size_t> order = unknownsInOrder(form, Layout(form));
    const auto count = static_cast<Eigen::Index>(order.size());
    mean.resize(count);
    modes.resize(count, static_cast<Eigen::Index>(prior.modes.size()));
    for (size_t i = 0; i < order.size(); ++i) {
        const auto unknown = static_cast<Eigen::Index>(order[i]);
        mean(unknown) = static_cast<double>(prior.mean[i]);
        for (size_t k = 0; k < prior.modes.size(); ++k)
            modes(unknown, static_cast<Eigen::Index>(k)) = static_cast<double>(prior.modes[k][i]);
    }
}

}  // namespace fbrdf

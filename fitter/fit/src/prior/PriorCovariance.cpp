#include "prior/PriorCovariance.h"

#include "prior/TableNumbers.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace fbrdf {
namespace {

constexpr double kFirstOrder = 0.1, kLevel = 1e-3;

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
    : form(prior.form), root(smoothnessRoot(prior.form))
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

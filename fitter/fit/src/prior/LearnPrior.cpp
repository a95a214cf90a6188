#include <fbrdf/fit/LearnPrior.h>

#include "prior/PriorCovariance.h"
#include "prior/TableNumbers.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <Eigen/Eigenvalues>

namespace fbrdf {
namespace {

using Index = Eigen::Index;
using Symmetric = Eigen::Map<const PriorMatrix>;

// What is not seen counts a little: as samples do, and as curvature.
constexpr double kSampled = 0.1, kRough = 1e-5, kRidge = 1e-9;

Symmetric symmetric(const std::vector<double>& lower, Index unknowns)
{
    return {lower.data(), unknowns, unknowns};
}

PriorMatrix metricOf(const KnownMaterials& known)
{
    const Layout layout(known.form);
    const Index n = layout.unknowns();
    const PriorMatrix rough = roughness(known.form, layout);
    PriorMatrix metric = symmetric(known.seen, n) + kSampled * symmetric(known.sampled, n) +
                         kRough / rough.trace() * rough;
    metric.diagonal().array() += kRidge;
    return metric;
}

std::vector<float> inOrder(const PriorVector& unknowns, const std::vector<size_t>& order)
{
    std::vector<float> numbers;
    for (const size_t u : order)
        numbers.push_back(static_cast<float>(unknowns(static_cast<Index>(u))));
    return numbers;
}

}  // namespace

TablePrior learnTablePrior(const KnownMaterials& known, int modes)
{
    const auto count = static_cast<Index>(known.tables.size());
    if (modes < 1 || modes > count)
        throw Error(ErrorKind::usage, "modes",
                    Found(std::to_string(modes)).expected("1 to " + std::to_string(count)));
    const Layout layout(known.form);
    PriorMatrix tables(layout.unknowns(), count);
    for (Index k = 0; k < count; ++k)
        tables.col(k) = Eigen::Map<const PriorVector>(known.tables[static_cast<size_t>(k)].data(),
                                                      layout.unknowns());
    const PriorVector mean = tables.rowwise().mean();
    tables.colwise() -= mean;
    const PriorMatrix metric = metricOf(known);
    const PriorMatrix products =
        tables.transpose() * (metric.selfadjointView<Eigen::Lower>() * tables);
    const Eigen::SelfAdjointEigenSolver<PriorMatrix> eigen(products);
    const std::vector<size_t> order = unknownsInOrder(known.form, layout);
    TablePrior prior{known.form, inOrder(mean, order), {}};
    // Of the smallest eigenvalue first.
    for (Index k = count - 1; k >= count - modes; --k)
        prior.modes.push_back(inOrder(
            tables * eigen.eigenvectors().col(k) / std::sqrt(static_cast<double>(count)), order));
    return prior;
}

}  // namespace fbrdf

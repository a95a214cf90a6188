#include "solve/SmoothSystem.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <numeric>

namespace fbrdf {
namespace {

constexpr double kFirstOrder = 0.03;  // of a second difference: decides where there is no curvature

size_t indexOf(const SmoothnessRow& row, int entry)
{
    return static_cast<size_t>(row.unknown[entry]);
}

}  // namespace

Smoothness::Smoothness(const Form& form, const Layout& layout)
    : rows(smoothnessRows(form, layout, kFirstOrder)), unknowns(form.tables.size())
{
    for (size_t t = 0; t < form.tables.size(); ++t)
        for (int i = 0; i < texelCount(form.tables[t].domain); ++i)
            unknowns[t].push_back(layout.unknownOf(t, i));
}

std::vector<double> Smoothness::scales(const std::vector<double>& diagonal) const
{
    std::vector<double> scales;
    for (const auto& table : unknowns) {
        double sum = 0.0;
        for (const int u : table) sum += diagonal[static_cast<size_t>(u)];
        scales.push_back(sum / static_cast<double>(table.size()));
    }
    double mean =
        std::accumulate(scales.begin(), scales.end(), 0.0) / static_cast<double>(scales.size());
    // A channel without a single value above the floor leaves everything to the smoothness.
    if (mean == 0.0) mean = 1.0;
    for (double& scale : scales)
        if (scale == 0.0) scale = mean;
    return scales;
}

SmoothSystem::SmoothSystem(BorderedMatrix data, const Smoothness& smoothness, Workspace& workspace)
    : data_(std::move(data)), smoothness_(smoothness), workspace_(workspace)
{
    std::vector<double> diagonal;
    for (size_t u = 0; u < data_.shape.unknowns(); ++u) diagonal.push_back(data_.at(u, u));
    scales_ = smoothness.scales(diagonal);
    ridge_ = kGaugeRidge * std::accumulate(scales_.begin(), scales_.end(), 0.0) /
             static_cast<double>(scales_.size());
}

Cholesky SmoothSystem::factored(double strength, double damping) const
{
    BorderedMatrix matrix(data_.shape, workspace_.any(data_.values.size()));
    std::copy(data_.values.begin(), data_.values.end(), matrix.values.begin());
    for (const SmoothnessRow& row : smoothness_.rows) {
        const double factor = strength * scales_[static_cast<size_t>(row.table)];
        for (int a = 0; a < row.count; ++a)
            for (int b = 0; b < row.count; ++b)
                if (row.unknown[b] <= row.unknown[a])
                    matrix.at(static_cast<size_t>(row.unknown[a]),
                              static_cast<size_t>(row.unknown[b])) +=
                        factor * row.weight[a] * row.weight[b];
    }
    for (size_t u = 0; u < matrix.shape.unknowns(); ++u)
        matrix.at(u, u) = (matrix.at(u, u) + ridge_) * (1.0 + damping);
    return Cholesky(std::move(matrix));
}

std::shared_ptr<const Cholesky> SmoothSystem::keptFactor(double strength) const
{
    {
        const std::lock_guard lock(mutex_);
        const auto found = kept_.find(strength);
        if (found != kept_.end()) return found->second;
    }
    auto cholesky = std::make_shared<const Cholesky>(factored(strength, 0.0));
    const std::lock_guard lock(mutex_);
    return kept_.emplace(strength, std::move(cholesky)).first->second;
}

std::vector<double> SmoothSystem::step(std::vector<double> right, const double* x, size_t columns,
                                       double strength, double damping,
                                       const std::string& form) const
{
    const size_t n = data_.shape.unknowns();
    FBRDF_ASSERT(right.size(), ==, n * columns);
    FBRDF_ASSERT(strength, >=, 0.0);
    for (size_t c = 0; c < columns; ++c)
        for (const SmoothnessRow& row : smoothness_.rows) {
            double bend = 0.0;
            for (int b = 0; b < row.count; ++b) bend += row.weight[b] * x[c * n + indexOf(row, b)];
            bend *= strength * scales_[static_cast<size_t>(row.table)];
            for (int a = 0; a < row.count; ++a)
                right[c * n + indexOf(row, a)] -= bend * row.weight[a];
        }
    const auto solve = [&](const Cholesky& cholesky) {
        if (!cholesky.ok())
            throw Error(
                ErrorKind::fit, form,
                Found("samples that leave the system singular").expected("directions that vary"));
        cholesky.solve(right.data(), columns);
    };
    if (keeps_ && damping == 0.0) {
        solve(*keptFactor(strength));
    } else {
        Cholesky cholesky = factored(strength, damping);
        solve(cholesky);
        workspace_.giveBack(cholesky.takeValues());
    }
    return right;
}

}  // namespace fbrdf

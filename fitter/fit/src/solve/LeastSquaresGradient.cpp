// Steps of large systems, by conjugate gradients: every iteration is a pass over the rows.
#include "solve/ConjugateGradients.h"
#include "solve/LeastSquaresRows.h"

namespace fbrdf {
namespace {

constexpr double kRidge = 1e-11;  // of the mean diagonal: fixes the gauge between factors

// Each smoothness row b adds sign strength b (b^T p).
void addSmoothness(LaneVector& result, const LaneVector& p, const Smoothness& smoothness,
                   const std::vector<Lanes>& strengths, double sign)
{
    for (const SmoothnessRow& row : smoothness.rows)
        for (size_t l = 0; l < kLanes; ++l) {
            double bend = 0.0;
            for (int b = 0; b < row.count; ++b)
                bend += row.weight[b] * p[static_cast<size_t>(row.unknown[b])][l];
            bend *= sign * strengths[static_cast<size_t>(row.table)][l];
            for (int a = 0; a < row.count; ++a)
                result[static_cast<size_t>(row.unknown[a])][l] += bend * row.weight[a];
        }
}

}  // namespace

/// The system of one step, as far as conjugate gradients need it.
struct LeastSquares::GradientProblem {
    const LeastSquares& problem;
    const StepOptions& options;
    RowOptions with;
    std::vector<NormalRows> kept;  ///< one a block, where the rows' geometry is kept too
    std::vector<Lanes> strengths;  ///< of smoothness, one a table
    LaneVector diagonal, right, ridge;

    GradientProblem(const LeastSquares& p, const State& x, const StepOptions& o)
        : problem(p),
          options(o),
          with{o, o.robust ? p.tukeyScale(x, o) : Vec3f(1.0f), Texels(p, x),
               p.layout_.sharedShape() ? Pass{0, 1, kLanes} : Pass{0, 3, kLanes},
               groupsOf({}, o.excludedFold)}
    {
        const size_t n = p.unknowns();
        if (p.store_->geometry()) kept.resize(p.store_->blocks());
        const LaneVector sums =
            accumulated(2 * n, [n](const NormalRows& made, double* sum, double* scratch) {
                double* const both[2] = {sum, sum + kLanes * n};
                rowKernels().diagonal(made.rows, made.entryLanes, both, scratch);
            });
        diagonal.assign(sums.begin(), sums.begin() + static_cast<std::ptrdiff_t>(n));
        right.assign(sums.begin() + static_cast<std::ptrdiff_t>(n), sums.end());
        addSmoothnessOf(x);
        // From here on only weights count: where nothing depends on the state, the one that costs
        // least will do.
        if (!p.dependsOnState(o)) with.texels = Texels(p, p.flatState());
    }

    /// Sums over all rows: add(rows, the part's sums, scratch of the kernels).
    template <class Add>
    LaneVector accumulated(size_t size, const Add& add)
    {
        std::vector<LaneVector> parts(kParts, LaneVector(size, Lanes{}));
        std::vector<NormalRows> passing(kParts);
        std::vector<std::vector<double>> kernelScratch(kParts);
        problem.forEachBlock([&](size_t part, size_t block, RowStore::Scratch& scratch) {
            NormalRows& rows = kept.empty() ? passing[part] : kept[block];
            if (rows.group.empty())
                problem.makeNormalRows(problem.store_->block(block, scratch), with, rows);
            kernelScratch[part].resize(static_cast<size_t>(rows.rows.width) * kLanes);
            add(rows, parts[part].data()->data(), kernelScratch[part].data());
            if (kept.empty()) rows.group.clear();
        });
        std::vector<double> total(kLanes * size, 0.0);
        for (const LaneVector& part : parts)
            for (size_t u = 0; u < size; ++u)
                for (size_t l = 0; l < kLanes; ++l) total[kLanes * u + l] += part[u][l];
        problem.options_.ranks.sum(total);
        LaneVector result(size);
        for (size_t u = 0; u < size; ++u)
            for (size_t l = 0; l < kLanes; ++l) result[u][l] = total[kLanes * u + l];
        return result;
    }

    void addSmoothnessOf(const State& x)
    {
        const size_t n = problem.unknowns();
        LaneVector state(n, Lanes{});
        strengths.assign(problem.form_.tables.size(), Lanes{});
        ridge.assign(n, Lanes{});
        for (size_t l = 0; l < with.pass.channels; ++l) {
            std::vector<double> lane(n);
            for (size_t u = 0; u < n; ++u) {
                lane[u] = diagonal[u][l];
                state[u][l] = x[l * n + u];
            }
            const std::vector<double> scales = problem.smoothness_.scales(lane);
            double mean = 0.0;
            for (size_t t = 0; t < scales.size(); ++t) {
                strengths[t][l] = options.smoothness * scales[t];
                mean += scales[t] / static_cast<double>(scales.size());
            }
            for (Lanes& r : ridge) r[l] = kRidge * mean;
        }
        for (const SmoothnessRow& row : problem.smoothness_.rows)
            for (int a = 0; a < row.count; ++a)
                for (size_t l = 0; l < kLanes; ++l)
                    diagonal[static_cast<size_t>(row.unknown[a])][l] +=
                        strengths[static_cast<size_t>(row.table)][l] * row.weight[a] *
                        row.weight[a];
        for (size_t u = 0; u < n; ++u)
            for (size_t l = 0; l < kLanes; ++l) {
                diagonal[u][l] += ridge[u][l];
                ridge[u][l] += options.damping * diagonal[u][l];
            }
        addSmoothness(right, state, problem.smoothness_, strengths, -1.0);
    }

    LaneVector operator()(const LaneVector& p)
    {
        LaneVector result =
            accumulated(p.size(), [&p](const NormalRows& made, double* sum, double* scratch) {
                rowKernels().apply(made.rows, made.entryLanes, p.data()->data(), sum, scratch);
            });
        addSmoothness(result, p, problem.smoothness_, strengths, 1.0);
        for (size_t u = 0; u < p.size(); ++u)
            for (size_t l = 0; l < kLanes; ++l) result[u][l] += ridge[u][l] * p[u][l];
        return result;
    }
};

State LeastSquares::conjugateGradientStep(const State& x, const StepOptions& options) const
{
    const GradientProblem gradient(*this, x, options);
    LaneVector delta;
    solveByConjugateGradients(gradient, gradient.diagonal, gradient.right, {options_.tolerance},
                              delta);
    State next = x;
    for (size_t l = 0; l < gradient.with.pass.channels; ++l)
        for (size_t u = 0; u < unknowns(); ++u) next[l * unknowns() + u] += bounded(delta[u][l]);
    return next;
}

}  // namespace fbrdf

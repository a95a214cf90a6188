// Steps of large systems, by conjugate gradients: every iteration is a pass over the rows.
#include "ConjugateGradients.h"
#include "LeastSquaresRows.h"

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
    Vec3f scale;
    Texels texels;
    Pass pass;
    std::vector<Lanes> strengths;  ///< of smoothness, one a table
    LaneVector diagonal, right, ridge;

    GradientProblem(const LeastSquares& p, const State& x, const StepOptions& o)
        : problem(p),
          options(o),
          scale(o.robust ? p.tukeyScale(x, o) : Vec3f(1.0f)),
          texels(p, x),
          pass(p.layout_.sharedShape() ? Pass{0, 1, kLanes} : Pass{0, 3, kLanes})
    {
        const size_t n = p.unknowns();
        const LaneVector sums = accumulated(2 * n, [n](const auto& row, LaneVector& sum) {
            for (size_t k = 0; k < row.width; ++k) {
                const auto u = static_cast<size_t>(row.unknown[k]);
                Lanes entry{};  // an unknown may stand in a row twice
                for (size_t j = 0; j < row.width; ++j)
                    for (size_t l = 0; row.unknown[j] == row.unknown[k] && l < kLanes; ++l)
                        entry[l] += laneOf(row.entry[j], l);
                for (size_t l = 0; l < kLanes; ++l) {
                    const double scaled = row.weight[l] * laneOf(row.entry[k], l);
                    sum[u][l] += scaled * entry[l];
                    sum[n + u][l] += scaled * row.residual[l];
                }
            }
        });
        diagonal.assign(sums.begin(), sums.begin() + static_cast<std::ptrdiff_t>(n));
        right.assign(sums.begin() + static_cast<std::ptrdiff_t>(n), sums.end());
        addSmoothnessOf(x);
        if (!p.dependsOnState(o)) texels = Texels(p, p.flatState());
    }

    template <class Add>
    LaneVector accumulated(size_t size, const Add& add) const
    {
        std::vector<LaneVector> parts(kParts, LaneVector(size, Lanes{}));
        problem.withEntries(pass, [&](auto one) { addRows<decltype(one)>(add, parts); });
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

    template <class Entry, class Add>
    void addRows(const Add& add, std::vector<LaneVector>& parts) const
    {
        problem.forEachBlock([&](size_t part, size_t block, RowStore::Scratch& scratch) {
            NormalRowBuffer<Entry> buffer(static_cast<size_t>(problem.maker_.width()) +
                                          problem.form_.terms.size());
            problem.forEachRow(block, scratch, texels, options, scale, [&](const Row& row, int) {
                problem.forEachNormalRow(row, pass, buffer, [&](const NormalRow<Entry>& normal) {
                    add(normal, parts[part]);
                });
            });
        });
    }

    void addSmoothnessOf(const State& x)
    {
        const size_t n = problem.unknowns();
        LaneVector state(n, Lanes{});
        strengths.assign(problem.form_.tables.size(), Lanes{});
        ridge.assign(n, Lanes{});
        for (size_t l = 0; l < pass.channels; ++l) {
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

    LaneVector operator()(const LaneVector& p) const
    {
        LaneVector result = accumulated(p.size(), [&p](const auto& row, LaneVector& sum) {
            Lanes along{};
            for (size_t k = 0; k < row.width; ++k)
                for (size_t l = 0; l < kLanes; ++l)
                    along[l] += laneOf(row.entry[k], l) * p[static_cast<size_t>(row.unknown[k])][l];
            for (size_t l = 0; l < kLanes; ++l) along[l] *= row.weight[l];
            for (size_t k = 0; k < row.width; ++k)
                for (size_t l = 0; l < kLanes; ++l)
                    sum[static_cast<size_t>(row.unknown[k])][l] +=
                        laneOf(row.entry[k], l) * along[l];
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
    for (size_t l = 0; l < gradient.pass.channels; ++l)
        for (size_t u = 0; u < unknowns(); ++u) next[l * unknowns() + u] += bounded(delta[u][l]);
    return next;
}

}  // namespace fbrdf

#include "solve/GradientStep.h"
namespace fbrdf {
namespace {

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

// Lane `l` of sums over rows, of which all lanes of an unknown stand side by side.
LaneVector lanesOf(const std::vector<double>& sums)
{
    LaneVector result(sums.size() / kLanes);
    for (size_t u = 0; u < result.size(); ++u)
        for (size_t l = 0; l < kLanes; ++l) result[u][l] = sums[kLanes * u + l];
    return result;
}

/// The system of one step, as far as conjugate gradients need it: the diagonal, the right-hand
/// side, and what the matrix does to a vector.
class GradientSystem {
public:
    GradientSystem(const LeastSquares& problem, const State& x, const StepOptions& options,
                   const Vec3f& scale)
        : problem_(problem),
          with_{RowWeights(problem, options, scale), Texels(problem, x),
                problem.layout().sharedShape() ? ChannelPass{0, 1, kLanes}
                                               : ChannelPass{0, 3, kLanes},
                groupsOf({}, options.excludedFold)}
    {
        if (problem.store().geometry()) kept_.resize(problem.store().blocks());
        sumDiagonal();
        weighSmoothness(options.smoothness);
        addSmoothnessToDiagonal(options.damping);
        addSmoothness(right_, lanes(x), problem.smoothness(), strengths_, -1.0);
        // From here on only weights count: where nothing depends on the state, any will do.
        if (!dependsOnState(problem, options)) with_.texels = Texels(problem, problem.flatState());
    }

    size_t channels() const { return with_.pass.channels; }
    const LaneVector& diagonal() const { return diagonal_; }
    const LaneVector& right() const { return right_; }

    LaneVector operator()(const LaneVector& p)
    {
        LaneVector result =
            accumulated(p.size(), [&p](const NormalRows& made, double* sum, double* scratch) {
                rowKernels().apply(made.rows(), made.entryLanes(), p.data()->data(), sum, scratch);
            });
        addSmoothness(result, p, problem_.smoothness(), strengths_, 1.0);
        for (size_t u = 0; u < p.size(); ++u)
            for (size_t l = 0; l < kLanes; ++l) result[u][l] += ridge_[u][l] * p[u][l];
        return result;
    }

private:
    /// Sums over all rows: add(rows, sums of the part, scratch of the kernels).
    template <class Add>
    LaneVector accumulated(size_t size, const Add& add)
    {
        std::vector<LaneVector> parts(kParts, LaneVector(size, Lanes{}));
        std::vector<NormalRows> passing(kParts);
        std::vector<std::vector<double>> kernelScratch(kParts);
        problem_.forEachBlock([&](size_t part, size_t block, RowStore::Scratch& scratch) {
            NormalRows& rows = kept_.empty() ? passing[part] : kept_[block];
            if (rows.empty()) rows.make(problem_, problem_.store().block(block, scratch), with_);
            kernelScratch[part].resize(static_cast<size_t>(rows.rows().width) * kLanes);
            add(rows, parts[part].data()->data(), kernelScratch[part].data());
            if (kept_.empty()) rows.clear();
        });
        std::vector<double> total(kLanes * size, 0.0);
        for (const LaneVector& part : parts)
            for (size_t u = 0; u < size; ++u)
                for (size_t l = 0; l < kLanes; ++l) total[kLanes * u + l] += part[u][l];
        problem_.options().ranks.sum(total);
        return lanesOf(total);
    }

    // One pass gives both: the sums for the diagonal, then those for the right-hand side.
    void sumDiagonal()
    {
        const size_t n = problem_.unknowns();
        const LaneVector sums =
            accumulated(2 * n, [n](const NormalRows& made, double* sum, double* scratch) {
                double* const both[2] = {sum, sum + kLanes * n};
                rowKernels().diagonal(made.rows(), made.entryLanes(), both, scratch);
            });
        const auto middle = sums.begin() + static_cast<std::ptrdiff_t>(n);
        diagonal_.assign(sums.begin(), middle);
        right_.assign(middle, sums.end());
    }

    // What the smoothness of each table weighs in each channel, and the ridge of each unknown.
    void weighSmoothness(double strength)
    {
        const size_t n = problem_.unknowns();
        strengths_.assign(problem_.form().tables.size(), Lanes{});
        ridge_.assign(n, Lanes{});
        for (size_t l = 0; l < channels(); ++l) {
            std::vector<double> lane(n);
            for (size_t u = 0; u < n; ++u) lane[u] = diagonal_[u][l];
            const std::vector<double> scales = problem_.smoothness().scales(lane);
            double mean = 0.0;
            for (size_t t = 0; t < scales.size(); ++t) {
                strengths_[t][l] = strength * scales[t];
                mean += scales[t] / static_cast<double>(scales.size());
            }
            for (Lanes& r : ridge_) r[l] = kGaugeRidge * mean;
        }
    }

    void addSmoothnessToDiagonal(double damping)
    {
        for (const SmoothnessRow& row : problem_.smoothness().rows)
            for (int a = 0; a < row.count; ++a)
                for (size_t l = 0; l < channels(); ++l)
                    diagonal_[static_cast<size_t>(row.unknown[a])][l] +=
                        strengths_[static_cast<size_t>(row.table)][l] * row.weight[a] *
                        row.weight[a];
        for (size_t u = 0; u < diagonal_.size(); ++u)
            for (size_t l = 0; l < kLanes; ++l) {
                diagonal_[u][l] += ridge_[u][l];
                ridge_[u][l] += damping * diagonal_[u][l];
            }
    }

    // A state with a lane a channel.
    LaneVector lanes(const State& x) const
    {
        const size_t n = problem_.unknowns();
        LaneVector result(n, Lanes{});
        for (size_t l = 0; l < channels(); ++l)
            for (size_t u = 0; u < n; ++u) result[u][l] = x[l * n + u];
        return result;
    }

    const LeastSquares& problem_;
    RowOptions with_;
    std::vector<NormalRows> kept_;  ///< one a block, where the rows' geometry is kept too
    std::vector<Lanes> strengths_;  ///< of smoothness, one a table
    LaneVector diagonal_, right_, ridge_;
};

}  // namespace

Step gradientStep(const LeastSquares& problem, const State& x, const StepOptions& options,
                  const Vec3f& scale)
{
    GradientSystem system(problem, x, options, scale);
    const SolverOptions& limits = problem.options().limits;
    LaneVector delta;
    const ConjugateGradientSummary summary = solveByConjugateGradients(
        [&system](const LaneVector& p) { return system(p); }, system.diagonal(), system.right(),
        {limits.systemTolerance, limits.maxSystemIterations}, delta);
    Step result{x, summary};
    for (size_t l = 0; l < system.channels(); ++l)
        for (size_t u = 0; u < problem.unknowns(); ++u)
            result.x[l * problem.unknowns() + u] += bounded(problem, delta[u][l]);
    return result;
}

}  // namespace fbrdf

#include "solve/SmoothnessChoice.h"

#include <fbrdf/base/Assert.h>

#include <limits>

namespace fbrdf {
namespace {

using States = std::vector<State>;

// Calls visit(part, rows, i, place of the fold in `folds`) for the samples of the folds. Of many
// samples some are visited: rows where they are kept, else whole blocks.
template <class Visit>
void forEachLeftOut(const LeastSquares& problem, const std::vector<int>& folds, const Visit& visit)
{
    constexpr size_t kRows = 262144;
    // What hashes to at most these numbers is visited.
    const uint64_t all = std::numeric_limits<uint64_t>::max(),
                   some = all / std::max<uint64_t>(1, problem.rows() / kRows);
    const bool isKept = problem.store().geometry() != nullptr;
    const uint64_t lastRow = isKept ? some : all, lastBlock = isKept ? all : some,
                   seed = problem.seed();
    problem.forEachBlock([&](size_t part, size_t block, RowStore::Scratch& scratch) {
        if (splitMix64(block ^ seed) > lastBlock) return;
        const RowStore::Block rows = problem.store().block(block, scratch);
        for (size_t i = 0; i < rows.geometry.count; ++i) {
            const uint64_t number = rows.geometry.number(i);
            if (splitMix64(number ^ ~seed) > lastRow) continue;
            const auto found = std::find(folds.begin(), folds.end(), foldOf(number, seed));
            if (found == folds.end()) continue;
            visit(part, rows, i, static_cast<size_t>(found - folds.begin()));
        }
    });
}

/// A weighted mean under way.
struct Mean {
    double sum = 0.0, weight = 0.0;

    void add(const WeightedRow& row)
    {
        for (int c = 0; c < 3; ++c) {
            const auto w = static_cast<double>(row.sampleWeight[c]);
            sum += w * std::abs(static_cast<double>(row.residual[c]));
            weight += w;
        }
    }
};

// For every part and state, the weighted sum of |log2 f - log2 g| over the samples of the state's
// fold, and the sum of the weights; processes can add these up. State k belongs to fold k /
// strengths.
std::vector<double> sumsLeftOut(const LeastSquares& problem, const std::vector<Texels>& states,
                                size_t strengths, const std::vector<int>& folds)
{
    const RowWeights weigh(problem, {}, Vec3f(1.0f));
    std::vector<std::vector<Mean>> means(kParts, std::vector<Mean>(states.size()));
    std::vector<Prediction> predicted(kParts);
    forEachLeftOut(problem, folds,
                   [&](size_t part, const RowStore::Block& rows, size_t i, size_t fold) {
                       for (size_t k = fold * strengths; k < (fold + 1) * strengths; ++k) {
                           predict(problem, rows.geometry, i, 1, states[k], predicted[part]);
                           means[part][k].add(weigh(rows, i, predicted[part].logG.data()));
                       }
                   });
    std::vector<double> sums;
    for (const std::vector<Mean>& part : means)
        for (const Mean& mean : part) sums.insert(sums.end(), {mean.sum, mean.weight});
    problem.options().ranks.sum(sums);
    return sums;
}

// For every strength, the sum over folds of the weighted mean |log2 f - log2 g| of the samples left
// out.
std::vector<double> foldErrors(const LeastSquares& problem, const std::vector<States>& states,
                               const std::vector<int>& folds)
{
    std::vector<Texels> texels;  // of every fold and strength
    for (const States& fold : states)
        for (const State& state : fold) texels.emplace_back(problem, state);
    const size_t strengths = states[0].size();
    const std::vector<double> sums = sumsLeftOut(problem, texels, strengths, folds);
    std::vector<double> errors(strengths, 0.0);
    for (size_t k = 0; k < texels.size(); ++k) {
        double sum = 0.0, weight = 0.0;
        for (size_t part = 0; part < kParts; ++part) {
            sum += sums[2 * (part * texels.size() + k)];
            weight += sums[2 * (part * texels.size() + k) + 1];
        }
        const double error = weight > 0.0 ? sum / weight : 0.0;
        errors[k % strengths] +=
            std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
    }
    return errors;
}

// The strongest of the strengths that are as good as the best: 8 bits store the smoother of two
// solutions better that the held-out samples cannot tell apart (Breiman et al. 1984: the
// one-standard-error rule, with a share in place of the standard error).
size_t smoothestNearLeast(const std::vector<double>& errors, const std::vector<double>& strengths)
{
    constexpr double kAsGood = 1.02;
    size_t best =
        static_cast<size_t>(std::min_element(errors.begin(), errors.end()) - errors.begin());
    const double most = errors[best] * kAsGood;
    for (size_t s = 0; s < errors.size(); ++s)
        if (errors[s] <= most && strengths[s] > strengths[best]) best = s;
    return best;
}

// The state after the step of each strength, for each fold without the samples of that fold.
std::vector<States> statesWithout(const LeastSquares& problem, const State& x,
                                  const std::vector<SharedSystems>& systems, double damping,
                                  const std::vector<double>& strengths, size_t folds)
{
    std::vector<States> states(folds, States(strengths.size(), x));
    // One task for every system, fold and strength, strengths fastest.
    const size_t trials = folds * strengths.size();
    parallelTasks(trials * systems.size(), problem.threads(), [&](size_t i) {
        const size_t fold = i % trials / strengths.size(), s = i % strengths.size();
        moveBy(problem, systems[i / trials], fold, strengths[s], damping, states[fold][s]);
    });
    for (States& fold : states)
        for (State& state : fold) repeatGrey(problem, state);
    return states;
}

}  // namespace

SmoothnessChoice stepWithBest(const LeastSquares& problem, const State& x,
                              const StepOptions& options, const Vec3f& scale,
                              const std::vector<double>& strengths, const std::vector<int>& folds)
{
    FBRDF_ASSERT(isLarge(problem), ==, false);
    FBRDF_ASSERT(strengths.size(), >, 0u);
    FBRDF_ASSERT(folds.size(), >, 0u);
    const auto systems = systemsAt(problem, x, options, scale, folds);
    const auto states =
        statesWithout(problem, x, systems, options.damping, strengths, folds.size());
    const size_t best = smoothestNearLeast(foldErrors(problem, states, folds), strengths);
    SmoothnessChoice choice{x, strengths[best]};
    parallelTasks(systems.size(), problem.threads(), [&](size_t i) {
        moveBy(problem, systems[i], folds.size(), choice.smoothness, options.damping, choice.x);
    });
    repeatGrey(problem, choice.x);
    return choice;
}

}  // namespace fbrdf

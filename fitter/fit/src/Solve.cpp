#include "Solve.h"

#include "Coarse.h"

#include <algorithm>
#include <vector>

namespace fbrdf {
namespace {

constexpr double kFirstSmoothness = 1e-3;
const std::vector<double> kSmoothnessLadder{1e-5, 1e-4, 1e-3, 1e-2, 1e-1};
constexpr int kRobustSteps = 3;  // after the plain one: four solves
constexpr int kMaxSteps = 24, kFineSteps = 4;
constexpr size_t kCoarseBlocks = 4;  // 32,768 samples find the way
constexpr double kFirstDamping = 1e-3, kMaxDamping = 1e3;
constexpr double kConverged = 1e-4;  // relative fall of the cost

bool isLinear(const LeastSquares& problem, Metric metric)
{
    return problem.form().terms.size() == 1 && metric == Metric::log;
}

// Levenberg-Marquardt: a step that does not lower the cost is taken back and damped ten times more.
State descend(const LeastSquares& problem, State x, StepOptions options, int maxSteps)
{
    double cost = problem.cost(x, options), damping = kFirstDamping;
    for (int i = 0; i < maxSteps && damping < kMaxDamping; ++i) {
        options.damping = damping;
        State next = problem.step(x, options);
        const double nextCost = problem.cost(next, options);
        if (!(nextCost < cost)) {
            damping *= 10.0;
            continue;
        }
        const double fall = (cost - nextCost) / cost;
        x = std::move(next);
        cost = nextCost;
        damping *= 0.2;
        if (fall < kConverged) break;
    }
    return x;
}

// A sum of terms: the way down is found on a quarter of the texels and few samples, the last steps
// are taken in full.
State solveSum(const LeastSquares& problem, const StepOptions& step)
{
    const LeastSquares coarse = problem.withForm(halved(problem.form()))
                                    .thinned(std::max<size_t>(1, problem.blocks() / kCoarseBlocks));
    const State x = descend(coarse, coarse.flatState(), step, kMaxSteps);
    return descend(problem, prolonged(coarse, x, problem), step, kFineSteps);
}

State solveAt(const LeastSquares& problem, const SolveOptions& options, double smoothness)
{
    StepOptions step;
    step.smoothness = smoothness;
    step.excludedFold = options.excludedFold;
    State x = problem.form().terms.size() == 1 ? problem.step(problem.flatState(), step)
                                               : solveSum(problem, step);
    step.metric = options.metric;
    if (options.metric != Metric::log) x = descend(problem, std::move(x), step, kMaxSteps);
    step.robust = options.robust;
    for (int i = 0; options.robust && i < kRobustSteps; ++i) {
        step.damping = isLinear(problem, options.metric) ? 0.0 : kFirstDamping;
        x = problem.step(x, step);
    }
    return x;
}

double chooseSmoothness(const LeastSquares& problem, const State& x, const SolveOptions& options)
{
    std::vector<double> error(kSmoothnessLadder.size(), 0.0);
    for (int fold = 0; fold < options.folds; ++fold) {
        StepOptions step;
        step.metric = options.metric;
        step.robust = options.robust;
        // Within a fit that leaves a fold out, that fold must not choose either.
        step.excludedFold =
            options.excludedFold == kNoFold ? fold : (options.excludedFold + 1) % kFolds;
        const auto states = problem.steps(x, step, kSmoothnessLadder);
        for (size_t s = 0; s < states.size(); ++s)
            error[s] += problem.foldError(states[s], step.excludedFold);
        if (options.excludedFold != kNoFold) break;
    }
    const auto best = std::min_element(error.begin(), error.end());
    return kSmoothnessLadder[static_cast<size_t>(best - error.begin())];
}

}  // namespace

Solution solve(const LeastSquares& problem, const SolveOptions& options)
{
    if (options.smoothness > 0.0)
        return {solveAt(problem, options, options.smoothness), options.smoothness};
    Solution solution{solveAt(problem, options, kFirstSmoothness), kFirstSmoothness};
    const double chosen = chooseSmoothness(problem, solution.x, options);
    if (chosen != kFirstSmoothness) {
        StepOptions step;
        step.smoothness = chosen;
        step.metric = options.metric;
        step.robust = options.robust;
        step.excludedFold = options.excludedFold;
        step.damping = isLinear(problem, options.metric) ? 0.0 : kFirstDamping;
        solution = {problem.step(solution.x, step), chosen};
    }
    return solution;
}

}  // namespace fbrdf

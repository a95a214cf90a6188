#include "solve/Solve.h"

#include "solve/Coarse.h"

#include <fbrdf/base/Error.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace fbrdf {
namespace {

constexpr double kFirstSmoothness = 1e-3;
const std::vector<double> kSmoothnessLadder{1e-5, 1e-4, 1e-3, 1e-2, 1e-1};
constexpr int kNoisySteps = 6;   // what lies in the noise is found slowly
constexpr int kRobustSteps = 3;  // after the plain one: four solves
constexpr int kMaxSteps = 24, kFineSteps = 4, kLastSteps = 2;
constexpr int kRounds = 3;             // of choosing the smoothness of a sum
constexpr size_t kCoarseRows = 32768;  // find the way for the halved form of a sum
// Rows that find it for all rows, on which a last step is taken: so many, and so many a texel.
constexpr size_t kStartRows = 65536, kStartRowsPerUnknown = 64;
constexpr double kFirstDamping = 1e-3, kMaxDamping = 1e3;
constexpr double kConverged = 1e-4;  // relative fall of the cost
constexpr double kWorse = 0.1;       // rise of the cost that more smoothness may have, relative

bool isLinear(const LeastSquares& problem, Metric metric)
{
    return problem.form().terms.size() == 1 && metric == Metric::log;
}

// The state after a step, or nothing where the system is singular: more damping may mend it.
std::optional<State> tryStep(const LeastSquares& problem, const State& x,
                             const StepOptions& options)
{
    try {
        return problem.step(x, options);
    } catch (const Error&) {
        return std::nullopt;
    }
}

// Levenberg-Marquardt: a step that does not lower the cost is taken back and damped ten times more.
State descend(const LeastSquares& problem, State x, StepOptions options, int maxSteps)
{
    double damping = kFirstDamping, cost = problem.cost(x, options, x);
    for (int i = 0; i < maxSteps && damping < kMaxDamping; ++i) {
        options.damping = damping;
        auto next = tryStep(problem, x, options);
        const double nextCost = next ? problem.cost(*next, options, x) : cost;
        if (!(nextCost < cost)) {
            damping *= 10.0;
            continue;
        }
        const double fall = (cost - nextCost) / cost;
        x = std::move(*next);
        if (fall < kConverged || i + 1 == maxSteps) break;
        cost = options.robust ? problem.cost(x, options, x) : nextCost;  // the scale is another
        // Robust weights may leave a texel of a weak term alone: it keeps some damping.
        damping = std::max(damping * 0.2, options.robust ? kFirstDamping : 0.0);
    }
    return x;
}

// Folds that choose the smoothness. Within a fit that leaves a fold out, that fold must not choose
// either.
std::vector<int> choosingFolds(const SolveOptions& options)
{
    if (options.excludedFold != kNoFold) return {(options.excludedFold + 1) % kFolds};
    std::vector<int> folds;
    for (int fold = 0; fold < options.folds; ++fold) folds.push_back(fold);
    return folds;
}

StepOptions lastStep(const LeastSquares& problem, const SolveOptions& options, double smoothness)
{
    StepOptions last;
    // Of one term: its steps need no cost, which f / g - 1 has not.
    last.unbiased = options.robust && isLinear(problem, options.metric) && problem.hasWholeNoise();
    last.smoothness = smoothness;
    last.metric = options.metric;
    last.robust = options.robust;
    last.excludedFold = options.excludedFold;
    return last;
}

// A last step of a problem that is not linear with the smoothness that suits it best; none where no
// step gets nearer.
Solution bestNearby(const LeastSquares& problem, const SolveOptions& options, const State& x,
                    const StepOptions& last)
{
    try {
        auto choice = problem.stepWithBest(x, last, kSmoothnessLadder, choosingFolds(options));
        if (problem.cost(choice.x, last, x) <= problem.cost(x, last, x) * (1.0 + kWorse))
            return {std::move(choice.x), choice.smoothness};
    } catch (const Error&) {
        // Singular: stay.
    }
    return {x, last.smoothness};
}

// A problem that is not linear leans on smoothness on its way down: less of it may do the better
// the nearer it has come. A given strength is kept.
Solution settled(const LeastSquares& problem, const SolveOptions& options, Solution near, int steps)
{
    const bool fixed = options.smoothness > 0.0;
    for (int round = 0; round < kRounds; ++round) {
        const double before = near.smoothness;
        StepOptions last = lastStep(problem, options, before);
        last.damping = kFirstDamping;
        if (fixed)
            near.smoothness = options.smoothness;
        else
            near = bestNearby(problem, options, near.x, last);
        near.x =
            descend(problem, std::move(near.x), lastStep(problem, options, near.smoothness), steps);
        if (fixed || near.smoothness == before) break;
    }
    return near;
}

// A sum of terms: the way down is found on a quarter of the texels and few samples, the last steps
// are taken in full.
Solution solveSum(const LeastSquares& problem, const SolveOptions& options)
{
    const LeastSquares thin = problem.thinned(kCoarseRows, options.excludedFold);
    const LeastSquares coarse = thin.withForm(halved(problem.form()));
    SolveOptions plain = options;
    plain.metric = Metric::log;
    plain.robust = false;
    SolveOptions part = plain;
    part.excludedFold = kNoFold;  // the thinned samples have none of it
    const StepOptions first =
        lastStep(coarse, part, std::max(options.smoothness, kFirstSmoothness));
    Solution near{descend(coarse, coarse.flatState(), first, kMaxSteps), first.smoothness};
    near = settled(coarse, part, std::move(near), kMaxSteps);
    near.x = descend(problem, prolonged(coarse, near.x, problem),
                     lastStep(problem, plain, near.smoothness), kFineSteps);
    return near;
}

// The plain solution, then the metric, then robust weights.
Solution solveStart(const LeastSquares& problem, const SolveOptions& options)
{
    const double strength = options.smoothness > 0.0 ? options.smoothness : kFirstSmoothness;
    StepOptions step = lastStep(problem, options, strength);
    step.metric = Metric::log;
    step.robust = step.unbiased = false;
    Solution near = problem.form().terms.size() == 1
                        ? Solution{problem.step(problem.flatState(), step), strength}
                        : solveSum(problem, options);
    step = lastStep(problem, options, near.smoothness);
    step.robust = step.unbiased = false;
    if (options.metric != Metric::log)
        near.x = descend(problem, std::move(near.x), step, kMaxSteps);
    step.robust = options.robust;
    if (!options.robust) return near;
    if (!isLinear(problem, options.metric))
        near.x = descend(problem, std::move(near.x), step, kRobustSteps);
    else
        for (int i = 0; i < (problem.hasWholeNoise() ? kNoisySteps : kRobustSteps); ++i) {
            near.x = problem.step(near.x, step);
            step.unbiased = problem.hasWholeNoise();  // what is near may be made right
        }
    return near;
}

// All samples, all texels, nothing known before.
Solution solveWhole(const LeastSquares& problem, const SolveOptions& options)
{
    const bool direct = isLinear(problem, options.metric);
    // A plain linear problem needs no start.
    const Solution start = direct && !options.robust
                               ? Solution{problem.flatState(), options.smoothness}
                               : solveStart(problem, options);
    if (!direct) return settled(problem, options, start, kFineSteps);
    const StepOptions last = lastStep(problem, options, start.smoothness);
    if (options.smoothness > 0.0) return {problem.step(start.x, last), last.smoothness};
    auto choice = problem.stepWithBest(start.x, last, kSmoothnessLadder, choosingFolds(options));
    return {std::move(choice.x), choice.smoothness};
}

// The last steps from a solution that is near.
Solution refined(const LeastSquares& problem, const SolveOptions& options, Solution near, int steps)
{
    StepOptions last = lastStep(problem, options, near.smoothness);
    const bool direct = isLinear(problem, options.metric);
    near.x = direct ? problem.step(near.x, last) : descend(problem, near.x, last, steps);
    return near;
}

size_t startRows(const LeastSquares& problem)
{
    return std::max(kStartRows, kStartRowsPerUnknown * problem.unknowns());
}

// Robust weights and shares of terms are statistics of the data: a part of many samples tells them,
// and the smoothness on the way (Bickel 1975, one-step M-estimators).
Solution solveMany(const LeastSquares& problem, const SolveOptions& options)
{
    SolveOptions part = options;
    part.excludedFold = kNoFold;  // the thinned samples have none of it
    part.folds = 1;
    return refined(problem, options,
                   solve(problem.thinned(startRows(problem), options.excludedFold), part), 1);
}

// Many texels start from half as many along every axis, and keep their smoothness.
Solution solveLarge(const LeastSquares& problem, const LeastSquares& coarse,
                    const SolveOptions& options)
{
    Solution near = solve(coarse, options);
    near.x = prolonged(coarse, near.x, problem);
    return refined(problem, options, std::move(near), kLastSteps);
}

}  // namespace

Solution solve(const LeastSquares& problem, const SolveOptions& options)
{
    const bool needsStart =
        problem.isLarge() || problem.dependsOnState(lastStep(problem, options, 0.0));
    if (needsStart && problem.rows() >= 2 * startRows(problem)) return solveMany(problem, options);
    if (!problem.isLarge()) return solveWhole(problem, options);
    return solveLarge(problem, problem.withForm(halved(problem.form())), options);
}

}  // namespace fbrdf

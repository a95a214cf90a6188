#include "solve/Solve.h"

#include "solve/Coarse.h"
#include "solve/SmoothnessChoice.h"

#include <fbrdf/base/Error.h>

#include <algorithm>

namespace fbrdf {
namespace {

constexpr double kFirstSmoothness = 1e-3;
const std::vector<double> kSmoothnessLadder{1e-5, 1e-4, 1e-3, 1e-2, 1e-1};
constexpr int kNoisySteps = 6;      // data in the noise converge slowly
constexpr int kRobustSteps = 3;     // after the plain one: four solves
constexpr int kFirstFineSteps = 2;  // before robust ones
constexpr int kFineSteps = 4, kLastSteps = 2, kLargeSteps = 12;
constexpr int kRounds = 3;             // of choosing the smoothness of a sum
constexpr size_t kCoarseRows = 32768;  // enough for the descent of a sum in its halved form
// Rows of the part from which a fit of many rows starts: so many, or so many a texel.
constexpr size_t kStartRows = 65536, kStartRowsPerUnknown = 64;
constexpr double kChoiceDamping = 1e-3;  // of a step that chooses the smoothness of a sum
constexpr double kWorse = 0.1;           // rise of the cost that more smoothness may have, relative

// The strengths about one that is near the best.
std::vector<double> strengthsAbout(double strength)
{
    constexpr double kStep = 10.0 * 1.01;  // of the ladder, and rounding
    std::vector<double> about;
    for (const double other : kSmoothnessLadder)
        if (other < strength * kStep && strength < other * kStep) about.push_back(other);
    return about;
}

bool isLinear(const LeastSquares& problem, Metric metric)
{
    return problem.terms() == 1 && metric == Metric::log;
}

// What the last steps of a problem minimise. Residuals f / g - 1 have no cost that a descent could
// lower, so only linear problems, which need none, use them.
StepOptions lastStep(const LeastSquares& problem, const SolveOptions& options)
{
    StepOptions last;
    last.unbiased = options.robust && isLinear(problem, options.metric) && problem.hasWholeNoise();
    last.smoothness = options.smoothness;
    last.metric = options.metric;
    last.robust = options.robust;
    last.excludedFold = options.excludedFold;
    return last;
}

size_t startRows(const LeastSquares& problem)
{
    return std::max(kStartRows, kStartRowsPerUnknown * problem.unknowns());
}

/// The steps of one problem.
class Solver {
public:
    Solver(const LeastSquares& problem, const SolveOptions& options)
        : problem_(problem), options_(options), last_(lastStep(problem, options))
    {
    }

    Solution solve() const
    {
        if (options_.start && options_.excludedFold != kNoFold && isFixed())
            return refined(known(), kFineSteps);
        const bool needsStart = isLarge(problem_) || dependsOnState(problem_, last_);
        if (needsStart && problem_.rows() >= 2 * startRows(problem_)) return solveMany();
        return isLarge(problem_) ? solveLarge() : solveWhole();
    }

private:
    bool isDirect() const { return isLinear(problem_, options_.metric); }
    bool isFixed() const { return options_.smoothness > 0.0; }

    StepOptions lastWith(double smoothness) const
    {
        StepOptions step = last_;
        step.smoothness = smoothness;
        return step;
    }

    // A plain step towards least squares of logarithms, from which the others start.
    StepOptions firstWith(double smoothness) const
    {
        StepOptions step = lastWith(smoothness);
        step.metric = Metric::log;
        step.robust = step.unbiased = false;
        return step;
    }

    // Folds that choose the smoothness. Within a fit that leaves a fold out, that fold must not
    // choose either.
    std::vector<int> choosingFolds() const
    {
        if (options_.excludedFold != kNoFold) return {(options_.excludedFold + 1) % kFolds};
        std::vector<int> folds;
        for (int fold = 0; fold < options_.folds; ++fold) folds.push_back(fold);
        return folds;
    }

    // The options for a part of the samples that has none of the excluded fold.
    SolveOptions partOptions() const
    {
        SolveOptions part = options_;
        part.excludedFold = kNoFold;
        return part;
    }

    // All samples, all texels, nothing known before.
    Solution solveWhole() const
    {
        if (!isDirect()) return settled(start(), {kFineSteps});
        // A plain linear problem needs no start.
        Solution near =
            options_.robust ? start() : Solution{problem_.flatState(), options_.smoothness, {}};
        if (isFixed()) return reweight(problem_, std::move(near), lastWith(near.smoothness), 1);
        const Vec3f scale = residualScale(problem_, near.x, last_);
        near = chosen(std::move(near), last_, scale, kSmoothnessLadder);
        near.summary.termination = Termination::solved;
        return near;
    }

    // The plain solution, then the metric, then robust weights.
    Solution start() const
    {
        Solution near = problem_.terms() == 1 ? plainStep() : solveSum();
        StepOptions step = lastWith(near.smoothness);
        step.robust = step.unbiased = false;
        if (options_.metric != Metric::log) near = descend(problem_, std::move(near), step);
        if (!options_.robust) return near;
        step.robust = true;
        return isDirect() ? reweighted(std::move(near), step)
                          : descend(problem_, std::move(near), step, {kRobustSteps});
    }

    Solution known() const { return {options_.start->x, options_.start->smoothness, {}}; }

    Solution plainStep() const
    {
        const StepOptions step = firstWith(isFixed() ? options_.smoothness : kFirstSmoothness);
        return reweight(problem_, {problem_.flatState(), 0.0, {}}, step, 1);
    }

    // Robust steps of a linear problem. Residuals f / g - 1 are for a state that is near: the first
    // step takes logarithms.
    Solution reweighted(Solution near, StepOptions step) const
    {
        const int steps = problem_.hasWholeNoise() ? kNoisySteps : kRobustSteps;
        near = reweight(problem_, std::move(near), step, 1);
        step.unbiased = problem_.hasWholeNoise();
        return reweight(problem_, std::move(near), step, steps - 1);
    }

    // A sum of terms: the way down is found on a quarter of the texels and few samples, the last
    // steps are taken in full.
    Solution solveSum() const
    {
        Solution near = options_.start ? known() : ofPart();
        const StepOptions fine = firstWith(near.smoothness);
        return descend(problem_, std::move(near), fine,
                       {options_.robust ? kFirstFineSteps : kFineSteps});
    }

    // Few samples and a quarter of the texels.
    Solution ofPart() const
    {
        const LeastSquares thin = problem_.thinned(kCoarseRows, options_.excludedFold);
        const LeastSquares coarse = thin.withForm(halved(problem_.form()));
        SolveOptions part = partOptions();
        part.metric = Metric::log;
        part.robust = false;
        const Solver solver(coarse, part);
        const StepOptions first = solver.lastWith(std::max(options_.smoothness, kFirstSmoothness));
        Solution near = descend(coarse, {coarse.flatState(), 0.0, {}}, first);
        near = solver.settled(std::move(near), {});
        near.x = prolonged(coarse, near.x, problem_);
        return near;
    }

    // A problem that is not linear leans on smoothness on its way down: less of it may do the
    // better the nearer it has come. A given strength is kept.
    Solution settled(Solution near, const StepBudget& budget) const
    {
        for (int round = 0; round < kRounds; ++round) {
            const double before = near.smoothness;
            if (isFixed())
                near.smoothness = options_.smoothness;
            else
                near = bestNearby(std::move(near));
            const StepOptions last = lastWith(near.smoothness);
            near = descend(problem_, std::move(near), last, budget);
            if (isFixed() || near.smoothness == before) break;
        }
        return near;
    }

    // A step with the smoothness that suits the problem best; none where no step gets nearer.
    Solution bestNearby(Solution near) const
    {
        StepOptions last = lastWith(near.smoothness);
        const Vec3f scale = residualScale(problem_, near.x, last);
        const double most = cost(problem_, near.x, last, scale) * (1.0 + kWorse);
        last.damping = kChoiceDamping;
        try {
            Solution next = chosen(near, last, scale, strengthsAbout(near.smoothness));
            if (cost(problem_, next.x, last, scale) <= most) return next;
        } catch (const Error&) {
            // The system is singular: stay.
        }
        return near;
    }

    // A step with the smoothness that does best on samples left out.
    Solution chosen(Solution near, const StepOptions& step, const Vec3f& scale,
                    const std::vector<double>& strengths) const
    {
        SmoothnessChoice choice =
            stepWithBest(problem_, near.x, step, scale, strengths, choosingFolds());
        near.x = std::move(choice.x);
        near.smoothness = choice.smoothness;
        ++near.summary.iterations;
        return near;
    }

    // The last steps from a solution that is near.
    Solution refined(Solution near, int steps) const
    {
        const StepOptions last = lastWith(near.smoothness);
        return isDirect() ? reweight(problem_, std::move(near), last, 1)
                          : descend(problem_, std::move(near), last, {steps});
    }

    // Robust weights and shares of terms are statistics of the data: a part of many samples gives
    // them, and the smoothness on the way (Bickel 1975, one-step M-estimators).
    Solution solveMany() const
    {
        SolveOptions part = partOptions();
        part.folds = 1;
        const LeastSquares thin = problem_.thinned(startRows(problem_), options_.excludedFold);
        return refined(Solver(thin, part).solve(), 1);
    }

    // Many texels start from half as many along every axis, and keep their smoothness. What only
    // the many can follow is no outlier: robust weights come after a step without them.
    Solution solveLarge() const
    {
        Solution near = options_.start ? known() : halfAsMany();
        if (!options_.robust) return refined(std::move(near), kLastSteps);
        const StepOptions first = firstWith(near.smoothness), last = lastWith(near.smoothness);
        if (!isDirect())
            return refined(descend(problem_, std::move(near), first, {kFineSteps}), kLargeSteps);
        return reweighted(reweight(problem_, std::move(near), first, 1), last);
    }

    Solution halfAsMany() const
    {
        const LeastSquares coarse = problem_.withForm(halved(problem_.form()));
        Solution near = Solver(coarse, options_).solve();
        near.x = prolonged(coarse, near.x, problem_);
        return near;
    }

    const LeastSquares& problem_;
    SolveOptions options_;
    StepOptions last_;
};

}  // namespace

Solution solve(const LeastSquares& problem, const SolveOptions& options)
{
    return Solver(problem, options).solve();
}

}  // namespace fbrdf

#include "solve/Descent.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>

#include <optional>

namespace fbrdf {
namespace {

constexpr double kFirstDamping = 1e-3;
constexpr double kMoreDamping = 10.0, kLessDamping = 0.2;

// The state after a step, or nothing where the system is singular: more damping may mend it.
std::optional<Step> tryStep(const LeastSquares& problem, const State& x, const StepOptions& options,
                            const Vec3f& scale)
{
    try {
        return step(problem, x, options, scale);
    } catch (const Error&) {
        return std::nullopt;
    }
}

class Descent {
public:
    Descent(const LeastSquares& problem, State x, const StepOptions& options)
        : problem_(problem), options_(options), x_(std::move(x))
    {
        options_.damping = kFirstDamping;
        weighAnew();
        summary_.cost = cost_;
    }

    /// Tries steps until one of the limits ends them.
    void run(int steps, Termination afterAll)
    {
        const SolverOptions& limits = problem_.options().limits;
        summary_.termination = Termination::noDescent;
        while (options_.damping < limits.maxDamping) {
            const bool isLower = tryOnce();
            const bool hasConverged = isLower && summary_.lastFall < limits.costTolerance;
            if (hasConverged || summary_.iterations == steps) {
                summary_.termination = hasConverged ? Termination::converged : afterAll;
                break;
            }
            if (isLower)
                relax();
            else
                options_.damping *= kMoreDamping;
        }
        if (!isSystemSolved_) summary_.termination = Termination::systemLimit;
    }

    State takeState() { return std::move(x_); }
    const SolverSummary& summary() const { return summary_; }

private:
    void weighAnew()
    {
        scale_ = residualScale(problem_, x_, options_);
        cost_ = cost(problem_, x_, options_, scale_);
    }

    // Takes the step if it lowers the cost.
    bool tryOnce()
    {
        ++summary_.iterations;
        auto next = tryStep(problem_, x_, options_, scale_);
        if (!next) return false;
        summary_.systemIterations += next->system.iterations;
        nextCost_ = cost(problem_, next->x, options_, scale_);
        if (!(nextCost_ < cost_)) return false;
        summary_.lastFall = (cost_ - nextCost_) / cost_;
        summary_.cost = nextCost_;
        isSystemSolved_ = next->system.isSolved;
        x_ = std::move(next->x);
        return true;
    }

    // After a step that was taken. Robust weights may leave a texel of a weak term without any: it
    // keeps some damping.
    void relax()
    {
        if (options_.robust)
            weighAnew();  // the scale of the residuals has changed
        else
            cost_ = nextCost_;
        options_.damping =
            std::max(options_.damping * kLessDamping, options_.robust ? kFirstDamping : 0.0);
    }

    const LeastSquares& problem_;
    StepOptions options_;
    State x_;
    Vec3f scale_{1.0f};
    double cost_ = 0.0, nextCost_ = 0.0;
    bool isSystemSolved_ = true;
    SolverSummary summary_;
};

}  // namespace

Solution descend(const LeastSquares& problem, Solution start, const StepOptions& options,
                 const StepBudget& budget)
{
    FBRDF_ASSERT(options.unbiased, ==, false);  // f / g - 1 has no cost that steps could lower
    const int limit = problem.options().limits.maxSteps;
    const bool isPlanned = budget.planned > 0 && budget.planned < limit;
    Descent descent(problem, std::move(start.x), options);
    descent.run(isPlanned ? budget.planned : limit,
                isPlanned ? Termination::plannedSteps : Termination::stepLimit);
    start.x = descent.takeState();
    start.smoothness = options.smoothness;
    start.summary += descent.summary();
    return start;
}

Solution reweight(const LeastSquares& problem, Solution start, const StepOptions& options,
                  int count)
{
    SolverSummary summary;
    summary.iterations = count;
    summary.termination = Termination::solved;
    for (int i = 0; i < count; ++i) {
        Step next = step(problem, start.x, options);
        summary.systemIterations += next.system.iterations;
        if (!next.system.isSolved) summary.termination = Termination::systemLimit;
        start.x = std::move(next.x);
    }
    start.smoothness = options.smoothness;
    start.summary += summary;
    return start;
}

}  // namespace fbrdf

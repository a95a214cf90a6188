#include "solve/Steps.h"

#include "solve/GradientStep.h"

#include <fbrdf/base/Assert.h>

namespace fbrdf {
namespace {

// Numbers of a system that is factored; 64 MB. Larger ones go to conjugate gradients.
constexpr size_t kMostFactored = size_t{2} << 20;

Step factoredStep(const LeastSquares& problem, const State& x, const StepOptions& options,
                  const Vec3f& scale)
{
    // Where nothing depends on the state, any will do: that whose rows cost least.
    const bool fromX = dependsOnState(problem, options) || options.damping > 0.0;
    State next = fromX ? x : problem.flatState();
    const auto all = systemsAt(problem, next, options, scale, {});
    parallelTasks(all.size(), problem.threads(), [&](size_t i) {
        moveBy(problem, all[i], 0, options.smoothness, options.damping, next);
    });
    repeatGrey(problem, next);
    return {std::move(next), {}};
}

}  // namespace

bool isLarge(const LeastSquares& problem)
{
    const SystemSolver solver = problem.options().solver;
    if (solver != SystemSolver::automatic) return solver == SystemSolver::conjugateGradients;
    return shapeOf(problem.layout()).size() > kMostFactored;
}

double bounded(const LeastSquares& problem, double octaves)
{
    constexpr double kMost = 4.0;
    return problem.terms() > 1 ? std::clamp(octaves, -kMost, kMost) : octaves;
}

void moveBy(const LeastSquares& problem, const SharedSystems& shared, size_t k, double strength,
            double damping, State& x)
{
    FBRDF_ASSERT(k, <, shared.systems.size());
    double* columns = x.data() + shared.first * problem.unknowns();
    const std::vector<double> step = shared.systems[k]->step(
        shared.right[k], columns, shared.channels, strength, damping, problem.form().name);
    for (size_t u = 0; u < step.size(); ++u) columns[u] += bounded(problem, step[u]);
}

void repeatGrey(const LeastSquares& problem, State& x)
{
    if (!problem.statistics().grey || problem.layout().sharedShape()) return;
    for (size_t i = problem.unknowns(); i < x.size(); ++i) x[i] = x[i - problem.unknowns()];
}

Step step(const LeastSquares& problem, const State& x, const StepOptions& options,
          const Vec3f& scale)
{
    FBRDF_ASSERT(x.size(), ==, problem.columns() * problem.unknowns());
    return isLarge(problem) ? gradientStep(problem, x, options, scale)
                            : factoredStep(problem, x, options, scale);
}

Step step(const LeastSquares& problem, const State& x, const StepOptions& options)
{
    return step(problem, x, options, residualScale(problem, x, options));
}

}  // namespace fbrdf

// DescentTest.cpp - each limit of SolverOptions is the bound of the inequality in its comment, and
// a fit reports why its solver stopped. No GL.
#include "solve/Solve.h"

#include "Known.h"

#include <fbrdf/base/Error.h>
#include <gtest/gtest.h>

namespace fbrdf {
namespace {

/// A sum of two terms, which takes several steps.
class Descents : public testing::Test {
protected:
    Solution descent(const SolverOptions& limits, const StepBudget& budget = {}) const
    {
        LeastSquaresOptions options;
        options.limits = limits;
        const LeastSquares problem(makeForm("io+hdio", 12), dataset_, statistics_, 1, 2, options);
        return descend(problem, {problem.flatState(), 0.0, {}}, {}, budget);
    }

private:
    const Source source_ = test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.1});
    const Dataset dataset_ = makeDataset(source_, 5000, 1, 2);
    const DataStatistics statistics_ =
        statisticsOf(someSamples(dataset_, FoldChoice::all(), 5000, 1), true, "data");
};

TEST_F(Descents, ConvergeWhenAStepLowersTheCostByLessThanTheTolerance)
{
    int before = 0;
    for (const double tolerance : {0.3, 1e-2, 1e-4}) {
        SolverOptions limits;
        limits.costTolerance = tolerance;
        limits.maxSteps = 200;
        const SolverSummary summary = descent(limits).summary;
        EXPECT_EQ(summary.termination, Termination::converged) << summary.text();
        EXPECT_LT(summary.lastFall, tolerance);
        EXPECT_GT(summary.iterations, before);
        EXPECT_FALSE(summary.hitLimit());
        before = summary.iterations;
    }
}

TEST_F(Descents, DoNotConvergeBeforeTheTolerance)
{
    SolverOptions limits;
    limits.maxSteps = 200;
    const int steps = descent(limits).summary.iterations;
    limits.maxSteps = steps - 1;  // the step before the last lowered the cost by more
    const SolverSummary summary = descent(limits).summary;
    EXPECT_EQ(summary.termination, Termination::stepLimit);
    EXPECT_GE(summary.lastFall, limits.costTolerance);
}

TEST_F(Descents, EndAtTheLimitOfSteps)
{
    for (const int most : {1, 3}) {
        SolverOptions limits;
        limits.maxSteps = most;
        const SolverSummary summary = descent(limits).summary;
        EXPECT_EQ(summary.iterations, most);
        EXPECT_EQ(summary.termination, Termination::stepLimit);
        EXPECT_TRUE(summary.hitLimit());
        EXPECT_NE(summary.text().find("limit of steps"), std::string::npos) << summary.text();
    }
}

TEST_F(Descents, OfAFewPlannedStepsHitNoLimit)
{
    const SolverSummary summary = descent({}, {2}).summary;
    EXPECT_EQ(summary.iterations, 2);
    EXPECT_EQ(summary.termination, Termination::plannedSteps);
    EXPECT_FALSE(summary.hitLimit());
}

TEST_F(Descents, TakeNoStepWhereEvenTheFirstDampingIsTooMuch)
{
    SolverOptions limits;
    limits.maxDamping = 1e-3;  // the first damping is not below it
    const Solution stayed = descent(limits);
    EXPECT_EQ(stayed.summary.termination, Termination::noDescent);
    EXPECT_EQ(stayed.summary.iterations, 0);
    EXPECT_GT(stayed.summary.cost, descent({}).summary.cost);
}

TEST(Limits, OfALargeSystemAreThoseOfItsResidualAndIterations)
{
    const Source source = test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.1});
    const Dataset dataset = makeDataset(source, 5000, 1, 2);
    const DataStatistics statistics =
        statisticsOf(someSamples(dataset, FoldChoice::all(), 5000, 1), true, "data");
    LeastSquaresOptions options;
    options.solver = SystemSolver::conjugateGradients;
    for (const double tolerance : {1e-2, 1e-6}) {
        options.limits.systemTolerance = tolerance;
        const LeastSquares problem(formHdio({12, 5, 5}), dataset, statistics, 1, 2, options);
        const auto system = step(problem, problem.flatState(), {}).system;
        EXPECT_TRUE(system.isSolved);
        EXPECT_LE(system.residual, tolerance);
    }
    options.limits.maxSystemIterations = 3;
    const LeastSquares problem(formHdio({12, 5, 5}), dataset, statistics, 1, 2, options);
    const auto system = step(problem, problem.flatState(), {}).system;
    EXPECT_EQ(system.iterations, 3);
    EXPECT_FALSE(system.isSolved);
    EXPECT_GT(system.residual, options.limits.systemTolerance);
    const Solution fitted = reweight(problem, {problem.flatState(), 0.0, {}}, {}, 1);
    EXPECT_EQ(fitted.summary.termination, Termination::systemLimit);
}

FitSummary summaryOf(const std::string& form, const SolverOptions& solver)
{
    FitOptions options;
    options.form = form;
    options.resolution = 12;
    options.solver = solver;
    const Source source = test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.1});
    return fitMaterial(test::scattered(source, 3000, 1), options).summary;
}

TEST(Reports, NameALimitThatWasHit)
{
    SolverOptions solver;
    solver.maxSteps = 1;
    const FitSummary summary = summaryOf("io+hdio", solver);
    EXPECT_TRUE(summary.solver.hitLimit());
    EXPECT_NE(summary.briefReport().find("limit of steps"), std::string::npos);
    EXPECT_EQ(summary.briefReport().find('\n'), std::string::npos);
    EXPECT_NE(summary.fullReport().find("limit of steps"), std::string::npos);
}

TEST(Reports, OfALinearFitAreSolved)
{
    const FitSummary summary = summaryOf("hdio", {});
    EXPECT_EQ(summary.solver.termination, Termination::solved);
    // A plain step, three with robust weights, and the one that chooses the smoothness.
    EXPECT_EQ(summary.solver.iterations, 5);
    EXPECT_GT(summary.solver.cost, 0.0);
    const std::string report = summary.fullReport();
    for (const char* word : {"solver", "smoothness", "samples", "seconds", "held out", "log_rms"})
        EXPECT_NE(report.find(word), std::string::npos) << word << " in " << report;
}

TEST(Reports, OfSingularValuesHaveNoSolver)
{
    EXPECT_EQ(summaryOf("svd2", {}).solver.termination, Termination::none);
}

TEST(Limits, ThatNoSolverCouldKeepAreRefused)
{
    for (double SolverOptions::*limit : {&SolverOptions::costTolerance, &SolverOptions::maxDamping,
                                         &SolverOptions::systemTolerance}) {
        FitOptions options;
        options.solver.*limit = 0.0;
        EXPECT_THROW(checkOptions(options), Error);
    }
    FitOptions options;
    options.solver.maxSteps = 0;
    EXPECT_THROW(checkOptions(options), Error);
}

}  // namespace
}  // namespace fbrdf

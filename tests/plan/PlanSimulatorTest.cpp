#include "PlanSimulator.h"

#include "PlanRequests.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

// The tester: a plan that is wrong in one of the ways that matter must not pass the simulation.
class WrongPlan : public ::testing::Test {
protected:
    bool passes(const Plan& plan) const
    {
        const auto nearer = simulatedFragment(form_, 3, 0.3, 1);
        const auto farther = simulatedFragment(form_, 3, 0.6, 2);
        const double expected = expectedValue(form_, nearer);
        const SimulatedPixel pixel = simulate(plan, {farther, nearer}, {123.0, 1.0});
        return std::abs(pixel.value - expected) < kRounding * expected;
    }
    Form form_ = formPqp(8, 1.0);
    Plan plan_ = planPasses(form_, twoLookup(3), modern());
};

TEST_F(WrongPlan, RightOnePasses)
{
    EXPECT_TRUE(passes(plan_));
}

TEST_F(WrongPlan, AddingToTheBackgroundFails)
{
    plan_.passes[0].blend = Blend::add;
    EXPECT_FALSE(passes(plan_));
}

TEST_F(WrongPlan, BlendingWithoutMatchingDepthFails)
{
    plan_.passes[1].depth = Depth::write;
    EXPECT_FALSE(passes(plan_));
}

TEST_F(WrongPlan, ForgettingTheLastFactorFails)
{
    plan_.passes.pop_back();
    EXPECT_FALSE(passes(plan_));
}

TEST_F(WrongPlan, LosingALightFails)
{
    plan_.passes.erase(plan_.passes.begin() + 1);
    EXPECT_FALSE(passes(plan_));
}

}  // namespace
}  // namespace fbrdf

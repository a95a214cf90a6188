#include "PlanSimulator.h"

#include "PlanRequests.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

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

class WrongLobes : public ::testing::Test {
protected:
    static PlanRequest request()
    {
        PlanRequest request = twoLookup(2);
        request.lobes = tiltedLobes(3);
        request.lobeLight.environment = true;
        return request;
    }
    bool passes(const Plan& plan) const
    {
        const auto fragment = simulatedFragment(form_, 2, 0.3, 1, 3);
        const double expected = expectedValue(form_, fragment);
        const SimulatedPixel pixel = simulate(plan, {fragment}, {123.0, 1.0});
        return std::abs(pixel.value - expected) < kRounding * expected;
    }
    Form form_ = formPqp(8, 1.0);
    Plan plan_ = planPasses(form_, request(), modern());
};

TEST_F(WrongLobes, RightOnesPass)
{
    EXPECT_TRUE(passes(plan_));
}

TEST_F(WrongLobes, LosingOneFails)
{
    --plan_.passes.back().lobes.count;
    EXPECT_FALSE(passes(plan_));
}

TEST_F(WrongLobes, AddingOneTwiceFails)
{
    plan_.passes.back().lobes.cosine = true;
    EXPECT_FALSE(passes(plan_));
}

TEST_F(WrongLobes, MultiplyingThemAsWellFails)
{
    std::swap(plan_.passes[1], plan_.passes[2]);
    std::swap(plan_.passes[2], plan_.passes[3]);
    EXPECT_FALSE(passes(plan_));
}

}  // namespace
}  // namespace fbrdf

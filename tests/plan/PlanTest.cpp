#include "PlanForms.h"
#include "PlanRequests.h"
#include "PlanSimulator.h"

#include <fbrdf/base/Error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

Form named(Form form, const std::string& name)
{
    form.name = name;
    return form;
}

struct Case {
    Form form;
    PlanRequest request;
};

std::string describeCase(const Case& c)
{
    return c.form.name + ", " + techniqueName(c.request.technique) + ", " +
           std::to_string(c.request.lights) + " lights, " +
           std::to_string(c.request.lightsPerPass) + " a pass, at most " +
           std::to_string(c.request.maxLookups) + " look-ups, " +
           colourFormatName(c.request.target) + (c.request.offscreen ? "" : ", no offscreen");
}

/// Every form, technique, number of lights, limit, target, with and without offscreen surfaces.
template <class Check>
void forEachCase(Check check)
{
    for (const Form& form : allForms())
        for (const Technique t : allTechniques())
            for (const int lights : {0, 1, 2, 3, 8, 9, 64})
                for (const int lightsPerPass : {1, 3, 8})
                    for (const int lookups : {0, 1, 2, 3, 4, 5, 20})
                        for (const ColourFormat target :
                             {ColourFormat::rgba32f, ColourFormat::rgba8, ColourFormat::rgba16f})
                            for (const bool offscreen : {true, false}) {
                                PlanRequest request;
                                request.technique = t;
                                request.lights = lights;
                                request.lightsPerPass = lightsPerPass;
                                request.maxLookups = lookups;
                                request.target = target;
                                request.offscreen = offscreen;
                                check(Case{form, request});
                            }
}

int limitOf(const PlanRequest& request)
{
    constexpr int kNone = 1 << 30;
    const int own = request.technique == Technique::twoLookup ? 2 : kNone;
    return std::min(own, request.maxLookups > 0 ? request.maxLookups : kNone);
}

int lightLimitOf(const PlanRequest& request)
{
    switch (request.technique) {
        case Technique::single: return request.lights;
        case Technique::batched: return request.lightsPerPass;
        case Technique::twoLookup: return 1;
    }
    return 0;
}

TEST(Plan, DrawsTheDefinitionInEveryCase)
{
    int feasible = 0;
    forEachCase([&feasible](const Case& c) {
        const Plan plan = planPasses(c.form, c.request, modern());
        if (!plan.feasible()) return;
        ++feasible;
        const auto fragment = simulatedFragment(c.form, c.request.lights, 0.5, 7);
        const double expected = expectedValue(c.form, fragment);
        const SimulatedPixel pixel = simulate(plan, {fragment}, {123.0, 1.0});
        ASSERT_NEAR(pixel.value, expected, kRounding * expected) << describeCase(c);
        ASSERT_EQ(pixel.depth, 0.5) << describeCase(c);
    });
    EXPECT_GT(feasible, 1000);
}

TEST(Plan, ShowsTheNearestFragmentWhateverTheOrder)
{
    forEachCase([](const Case& c) {
        const Plan plan = planPasses(c.form, c.request, modern());
        if (!plan.feasible()) return;
        const auto nearer = simulatedFragment(c.form, c.request.lights, 0.3, 1);
        const auto farther = simulatedFragment(c.form, c.request.lights, 0.6, 2);
        const double expected = expectedValue(c.form, nearer);
        for (const auto& order : {std::vector<SimulatedFragment>{nearer, farther},
                                  std::vector<SimulatedFragment>{farther, nearer}}) {
            const SimulatedPixel pixel = simulate(plan, order, {123.0, 1.0});
            ASSERT_NEAR(pixel.value, expected, kRounding * expected) << describeCase(c);
            ASSERT_EQ(pixel.depth, 0.3) << describeCase(c);
        }
    });
}

TEST(Plan, ACurveComesOnceAndLast)
{
    for (const Form& form : allForms())
        for (const Technique t : allTechniques())
            for (const int lights : {0, 1, 3, 9})
                for (const bool offscreen : {true, false}) {
                    Case c{form, {}};
                    c.request.technique = t;
                    c.request.lights = lights;
                    c.request.lightsPerPass = 2;
                    c.request.target = ColourFormat::rgba8;
                    c.request.offscreen = offscreen;
                    c.request.transfer = Transfer::toneMap;
                    const Plan plan = planPasses(form, c.request, modern());
                    ASSERT_TRUE(plan.feasible() || !offscreen) << describeCase(c) << plan.reason;
                    if (!plan.feasible()) continue;
                    for (size_t i = 0; i + 1 < plan.passes.size(); ++i) {
                        ASSERT_EQ(plan.passes[i].transfer, Transfer::linear) << describeCase(c);
                        ASSERT_NE(plan.passes[i].writes, Surface::target) << describeCase(c);
                    }
                    ASSERT_EQ(plan.passes.back().transfer, Transfer::toneMap) << describeCase(c);
                    auto nearer = simulatedFragment(form, lights, 0.3, 1),
                         farther = simulatedFragment(form, lights, 0.6, 2);
                    for (double& e : nearer.irradiance) e *= 1e-3;  // below the white point
                    const double expected =
                        transferred(Transfer::toneMap, 1.0, expectedValue(form, nearer));
                    for (const auto& order : {std::vector<SimulatedFragment>{nearer, farther},
                                              std::vector<SimulatedFragment>{farther, nearer}}) {
                        const SimulatedPixel pixel = simulate(plan, order, {123.0, 1.0});
                        ASSERT_NEAR(pixel.value, expected, 1e-9) << describeCase(c);
                        ASSERT_EQ(pixel.depth, 0.3) << describeCase(c);
                    }
                }
}

TEST(Plan, LeavesWhatIsInFrontAlone)
{
    forEachCase([](const Case& c) {
        const Plan plan = planPasses(c.form, c.request, modern());
        if (!plan.feasible()) return;
        const auto fragment = simulatedFragment(c.form, c.request.lights, 0.5, 3);
        const SimulatedPixel pixel = simulate(plan, {fragment}, {123.0, 0.2});
        ASSERT_EQ(pixel.value, 123.0) << describeCase(c);
        ASSERT_EQ(pixel.depth, 0.2) << describeCase(c);
    });
}

TEST(Plan, StaysWithinItsLimits)
{
    forEachCase([](const Case& c) {
        const Plan plan = planPasses(c.form, c.request, modern());
        int most = 0;
        for (const Pass& pass : plan.passes) {
            ASSERT_LE(pass.lookups, limitOf(c.request)) << describeCase(c);
            most = std::max(most, pass.lookups);
            ASSERT_LE(pass.lightCount, lightLimitOf(c.request)) << describeCase(c);
            ASSERT_TRUE(c.request.offscreen || pass.writes == Surface::target) << describeCase(c);
        }
        ASSERT_EQ(plan.maxLookups, most) << describeCase(c);
    });
}

TEST(Plan, ExistsWheneverOffscreenSurfacesDo)
{
    forEachCase([](const Case& c) {
        const Plan plan = planPasses(c.form, c.request, modern());
        ASSERT_TRUE(plan.feasible() || !c.request.offscreen) << describeCase(c) << plan.reason;
        ASSERT_EQ(plan.feasible(), !plan.passes.empty()) << describeCase(c);
    });
}

TEST(Plan, NeedsOnePassPerLightAndOneMoreForPqp)
{
    for (const int n : {1, 2, 8, 9, 64, 256}) {
        const Plan pqp = planPasses(formPqp(8, 1.0), twoLookup(n), modern());
        EXPECT_EQ(pqp.passes.size(), static_cast<size_t>(n + 1));
        EXPECT_EQ(pqp.maxLookups, 2);
        EXPECT_EQ(pqp.passes.back().blend, Blend::multiply);
        EXPECT_EQ(pqp.passes.back().lookups, 1);
        const Plan pqpr = planPasses(formPqpr(8, 0.5, 16), twoLookup(n), modern());
        EXPECT_EQ(pqpr.passes.size(), static_cast<size_t>(n + 1));
        EXPECT_EQ(pqpr.maxLookups, 2);
        const Plan hdio = planPasses(formHdio({8, 8, 8}), twoLookup(n), modern());
        EXPECT_EQ(hdio.passes.size(), static_cast<size_t>(n));
        EXPECT_EQ(hdio.maxLookups, 2);
    }
}

TEST(Plan, DrawsAllLightsInOnePassWhenSingle)
{
    for (const Form& form : allForms()) {
        PlanRequest request;
        request.lights = 256;
        const Plan plan = planPasses(form, request, modern());
        ASSERT_EQ(plan.passes.size(), 1u) << form.name;
        EXPECT_EQ(plan.passes[0].lightCount, 256) << form.name;
    }
    PlanRequest request;
    request.lights = 256;
    EXPECT_EQ(planPasses(formPqp(8, 1.0), request, modern()).maxLookups, 2 * 256 + 1);
    EXPECT_EQ(planPasses(formHdio({8, 8, 8}), request, modern()).maxLookups, 2 * 256);
}

TEST(Plan, SplitsASinglePassThatUniformsCannotHold)
{
    Capabilities small = modern();
    small.maxUniformVectors = 256;
    const Form form = formPqpr(8, 0.5, 16);
    const int room = maxLightsInUniforms(form, small);
    EXPECT_GT(room, 60);  // three vectors each, beside knots, ranges and the rest
    EXPECT_LT(room, 256 / 3);
    PlanRequest request;
    request.lights = 256;
    const Plan plan = planPasses(form, request, small);
    EXPECT_EQ(plan.passes.size(), static_cast<size_t>((256 + room - 1) / room));
    int lights = 0;
    for (const Pass& pass : plan.passes) lights += pass.lightCount;
    EXPECT_EQ(lights, 256);
}

TEST(Plan, HoldsOneLightEvenWithTheSmallestUniforms)
{
    Capabilities tiny;
    tiny.maxUniformVectors = 16;
    EXPECT_EQ(maxLightsInUniforms(formPqpr(8, 0.5, 64), tiny), 1);
}

TEST(Plan, BatchesLights)
{
    PlanRequest request;
    request.technique = Technique::batched;
    request.lights = 20;
    request.lightsPerPass = 8;
    const Plan plan = planPasses(formPqp(8, 1.0), request, modern());
    ASSERT_EQ(plan.passes.size(), 3u);
    EXPECT_EQ(plan.passes[2].lightCount, 4);
    EXPECT_EQ(plan.maxLookups, 2 * 8 + 1);
    request.maxLookups = 8;  // 3 lights with p(wo) in each pass: 7; 4 without: 5 + 1 < 7
    EXPECT_EQ(planPasses(formPqp(8, 1.0), request, modern()).passes.size(), 6u);
}

TEST(Plan, AddsUpInFloatWhereTheTargetIsCoarse)
{
    PlanRequest request = twoLookup(8);
    request.target = ColourFormat::rgba8;
    const Plan pqp = planPasses(formPqp(8, 1.0), request, modern());
    EXPECT_EQ(pqp.accumulation, ColourFormat::rgba32f);
    EXPECT_EQ(pqp.passes.size(), 9u);  // the composite is the multiplication
    EXPECT_EQ(pqp.passes.back().lookups, 2);
    const Plan hdio = planPasses(formHdio({8, 8, 8}), request, modern());
    EXPECT_EQ(hdio.passes.size(), 9u);
    request.technique = Technique::single;
    const Plan single = planPasses(formPqp(8, 1.0), request, modern());
    EXPECT_EQ(single.accumulation, ColourFormat::rgba8);
    EXPECT_EQ(single.passes.size(), 1u);
}

TEST(Plan, SaysWhyThereIsNone)
{
    PlanRequest request = twoLookup(2);
    request.offscreen = false;
    EXPECT_NE(planPasses(formWide(), request, modern()).reason.find("4 look-ups a light"),
              std::string::npos);
    const Form two = sum(formPqp(8, 1.0), formPqp(8, 1.0));
    EXPECT_NE(planPasses(two, request, modern()).reason.find("term 1"), std::string::npos);
    request.target = ColourFormat::rgba8;
    EXPECT_NE(planPasses(formPqp(8, 1.0), request, modern()).reason.find("RGBA8"),
              std::string::npos);
    request.offscreen = true;
    Capabilities old = modern();
    old.floatTargets = false;
    EXPECT_FALSE(planPasses(formPqp(8, 1.0), request, old).feasible());
}

TEST(Plan, AddsNothingNegativeUpWhereItWouldBeClamped)
{
    const Form two = sum(formHdio({8, 8, 8}), formHdio({8, 8, 8}));
    for (const bool offscreen : {true, false})
        for (const ColourFormat target :
             {ColourFormat::rgba8, ColourFormat::rgba16, ColourFormat::rgba16f,
              ColourFormat::rgba32f, ColourFormat::other}) {
            PlanRequest request = twoLookup(3);
            request.offscreen = offscreen;
            request.target = target;
            request.signs = true;
            const Plan plan = planPasses(two, request, modern());
            const bool isFloat = target == ColourFormat::rgba16f || target == ColourFormat::rgba32f;
            EXPECT_EQ(plan.feasible(), offscreen || isFloat) << colourFormatName(target);
            if (!plan.feasible()) {
                EXPECT_NE(plan.reason.find("signs"), std::string::npos);
                EXPECT_TRUE(plan.passes.empty());
                request.technique = Technique::single;  // one pass: the sum alone is clamped
                EXPECT_TRUE(planPasses(two, request, modern()).feasible());
                continue;
            }
            EXPECT_TRUE(std::isinf(plan.error.relative));  // terms may cancel
            const auto writes =
                std::count_if(plan.passes.begin(), plan.passes.end(),
                              [](const Pass& p) { return p.writes == Surface::target; });
            EXPECT_TRUE(isFloat || writes == 1) << colourFormatName(target);
        }
}

TEST(Plan, DrawsBlackWithoutLights)
{
    for (const Form& form : allForms()) {
        const Plan plan = planPasses(form, twoLookup(0), modern());
        ASSERT_EQ(plan.passes.size(), 1u);
        EXPECT_TRUE(plan.passes[0].parts.empty());
        EXPECT_EQ(plan.maxLookups, 0);
    }
}

TEST(Plan, RefusesRequestsOutOfRange)
{
    const Form form = named(formPqp(8, 1.0), "pqp");
    const auto expectUsage = [&form](const PlanRequest& request) {
        try {
            planPasses(form, request, modern());
            FAIL() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
        }
    };
    PlanRequest request;
    request.lights = -1;
    expectUsage(request);
    request = {};
    request.lightsPerPass = 0;
    expectUsage(request);
    request = {};
    request.maxLookups = -2;
    expectUsage(request);
    for (const double error : {-0.1, std::nan("")}) {
        request = {};
        request.maps.recombination = error;
        expectUsage(request);
    }
}

}  // namespace
}  // namespace fbrdf

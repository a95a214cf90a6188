// Plans with an environment or area lights: the lobes of each are added once, whatever the lights
// need.
#include <fbrdf/base/Error.h>

#include <gtest/gtest.h>

#include "PlanForms.h"
#include "PlanRequests.h"
#include "PlanSimulator.h"

#include <algorithm>
#include <utility>

namespace fbrdf {
namespace {

struct LobeCase {
    Form form;
    PlanRequest request;
};

std::string describeLobes(const LobeCase& c)
{
    return c.form.name + ", " + techniqueName(c.request.technique) + ", " +
           std::to_string(c.request.lights) + " lights, " + std::to_string(c.request.lobes.lobes) +
           " lobes, " + std::to_string(c.request.lobeLight.areaLights) + " area lights, at most " +
           std::to_string(c.request.maxLookups) + " look-ups, " +
           colourFormatName(c.request.target) + (c.request.offscreen ? "" : ", no offscreen") +
           (isCurved(c.request.transfer) ? ", curved" : "");
}

std::vector<std::pair<LobeLayout, LobeLight>> litLobes()
{
    return {{tiltedLobes(1), {true, 0}},  {tiltedLobes(2), {true, 0}},  {tiltedLobes(3), {true, 1}},
            {tiltedLobes(2), {false, 3}}, {tiltedLobes(1), {false, 1}}, {bentLobes(5), {true, 4}}};
}

template <class Check>
void forEachLobeCase(Check check)
{
    for (const Form& form : allForms())
        for (const Technique t : allTechniques())
            for (const int lights : {0, 1, 2, 9})
                for (const int lookups : {0, 1, 2, 3, 4, 20})
                    for (const ColourFormat target :
                         {ColourFormat::rgba32f, ColourFormat::rgba8, ColourFormat::rgba16f})
                        for (const Transfer transfer : {Transfer::linear, Transfer::srgb})
                            for (const bool offscreen : {true, false})
                                for (const auto& [lobes, light] : litLobes()) {
                                    PlanRequest request;
                                    request.technique = t;
                                    request.lights = lights;
                                    request.lightsPerPass = 2;
                                    request.maxLookups = lookups;
                                    request.target = target;
                                    request.transfer = transfer;
                                    request.offscreen = offscreen;
                                    request.lobes = lobes;
                                    request.lobeLight = light;
                                    check(LobeCase{form, request});
                                }
}

int lobeLimitOf(const PlanRequest& request)
{
    constexpr int kNone = 1 << 30;
    const int own = request.technique == Technique::twoLookup ? 2 : kNone;
    return std::min(own, request.maxLookups > 0 ? request.maxLookups : kNone);
}

TEST(LobePlan, DrawsTheDefinitionInEveryCase)
{
    int feasible = 0;
    forEachLobeCase([&feasible](const LobeCase& c) {
        const Plan plan = planPasses(c.form, c.request, modern());
        ASSERT_TRUE(plan.feasible() || !c.request.offscreen) << describeLobes(c) << plan.reason;
        if (!plan.feasible()) return;
        ++feasible;
        const int lobes = c.request.lobes.lobes;
        auto nearer =
                 simulatedFragment(c.form, c.request.lights, 0.3, 1, lobes, c.request.lobeLight),
             farther =
                 simulatedFragment(c.form, c.request.lights, 0.6, 2, lobes, c.request.lobeLight);
        if (isCurved(c.request.transfer)) {
            for (double& e : nearer.irradiance) e *= 1e-3;
            for (double& lobe : nearer.lobes) lobe *= 1e-2;  // below white
            for (auto& values : nearer.areaLobes)
                for (double& lobe : values) lobe *= 1e-2;
        }
        const double radiance = expectedValue(c.form, nearer),
                     expected = transferred(c.request.transfer, 1.0, radiance);
        const SimulatedPixel pixel = simulate(plan, {farther, nearer}, {123.0, 1.0});
        ASSERT_NEAR(pixel.value, expected, 1e-9 * expected) << describeLobes(c);
        ASSERT_EQ(pixel.depth, 0.3) << describeLobes(c);
        const SimulatedPixel hidden = simulate(plan, {farther, nearer}, {123.0, 0.2});
        ASSERT_EQ(hidden.value, 123.0) << describeLobes(c);
    });
    EXPECT_GT(feasible, 1000);
}

TEST(LobePlan, StaysWithinItsLimits)
{
    forEachLobeCase([](const LobeCase& c) {
        const Plan plan = planPasses(c.form, c.request, modern());
        for (const Pass& pass : plan.passes) {
            ASSERT_LE(pass.lookups, lobeLimitOf(c.request)) << describeLobes(c);
            ASSERT_TRUE(c.request.offscreen || pass.writes == Surface::target);
            // A batch is scissored to its lights; lobes reach every fragment.
            ASSERT_FALSE(c.request.technique == Technique::batched && pass.lit &&
                         !pass.lobes.isEmpty());
            ASSERT_FALSE(pass.blend == Blend::multiply && !pass.lobes.isEmpty());
        }
    });
}

TEST(LobePlan, IsTwoLookupsForOneLobeAndTwoPassesForThree)
{
    for (const int lights : {0, 3})
        for (const int lobes : {1, 2, 3}) {
            PlanRequest request = twoLookup(lights);
            request.lobes = tiltedLobes(lobes);
            request.lobeLight.environment = true;
            const Plan plan = planPasses(formHdio({8, 8, 8}), request, modern());
            const size_t own = lobes == 1 ? 1 : 2;
            ASSERT_EQ(plan.passes.size(), static_cast<size_t>(lights) + own) << lobes;
            EXPECT_EQ(plan.maxLookups, 2);
            const Pass& first = plan.passes[static_cast<size_t>(lights)];
            EXPECT_TRUE(first.lobes.cosine);
            EXPECT_EQ(first.lobes.count, 1);
            request.maxLookups = 1;
            request.lights = 0;
            EXPECT_EQ(planPasses(formHdio({8, 8, 8}), request, modern()).passes.size(),
                      static_cast<size_t>(lobes + 1));
        }
}

TEST(LobePlan, IsOnePassWithTheLightsWhenSingle)
{
    for (const Form& form : allForms())
        for (const int lights : {0, 1, 64}) {
            PlanRequest request;
            request.lights = lights;
            request.lobes = tiltedLobes(3);
            request.lobeLight.environment = true;
            for (const ColourFormat target : {ColourFormat::rgba32f, ColourFormat::rgba8}) {
                request.target = target;
                const Plan plan = planPasses(form, request, modern());
                ASSERT_EQ(plan.passes.size(), 1u) << form.name;
                EXPECT_EQ(plan.passes[0].writes, Surface::target);
                EXPECT_EQ(plan.passes[0].lobes.lookups(), 4);
            }
        }
}

TEST(LobePlan, TakesPassesOfItsOwnAfterBatches)
{
    PlanRequest request;
    request.technique = Technique::batched;
    request.lights = 20;
    request.lobes = tiltedLobes(3);
    request.lobeLight.environment = true;
    const Plan plan = planPasses(formPqp(8, 1.0), request, modern());
    ASSERT_EQ(plan.passes.size(), 4u);
    EXPECT_EQ(plan.passes.back().lobes.lookups(), 4);
    request.maxLookups = 8;
    const Plan limited = planPasses(formPqp(8, 1.0), request, modern());
    EXPECT_EQ(limited.passes.back().lobes.lookups(), 4);
}

TEST(LobePlan, SharesUniformsWithTheLights)
{
    Capabilities small = modern();
    small.maxUniformVectors = 256;
    const Form form = formPqp(8, 1.0);
    PlanRequest request;
    request.lights = 30;
    request.lobes = tiltedLobes(3);
    request.lobeLight.environment = true;  // 24 x 5 vectors
    const Plan beside = planPasses(form, request, small);
    ASSERT_EQ(beside.passes.size(), 1u);
    const LobeShare& share = beside.passes[0].lobes;
    EXPECT_EQ(share.vectors(), 120);
    EXPECT_LT(maxLightsInUniforms(form, small, share), maxLightsInUniforms(form, small));
    EXPECT_GE(maxLightsInUniforms(form, small, share), 30);
    request.lights = 70;
    EXPECT_EQ(planPasses(form, request, small).passes.size(), 2u);
    request.lobes = bentLobes(7);
    request.lobeLight.environment = true;  // 84 x 8 vectors in one pass
    const Plan bent = planPasses(form, request, small);
    ASSERT_TRUE(bent.feasible()) << bent.reason;
    int lobes = 0;
    for (const Pass& pass : bent.passes) {
        EXPECT_LE(3 * pass.lightCount + pass.lobes.vectors(), freeUniformVectors(form, small));
        lobes += pass.lobes.count;
    }
    EXPECT_EQ(lobes, 7);
    small.maxUniformVectors = 64;
    const Plan none = planPasses(form, request, small);
    EXPECT_FALSE(none.feasible());
    EXPECT_NE(none.reason.find("84 knots"), std::string::npos) << none.reason;
}

TEST(LobePlan, SaysWhyThereIsNone)
{
    PlanRequest request = twoLookup(2);
    request.lobes = tiltedLobes(2);
    request.lobeLight.environment = true;
    Capabilities old = modern();
    old.glsl = 120;
    EXPECT_NE(planPasses(formPqp(8, 1.0), request, old).reason.find("GL_ARB_shader_texture_lod"),
              std::string::npos);
    old.textureLod = true;
    EXPECT_TRUE(planPasses(formPqp(8, 1.0), request, old).feasible());
    old.glsl = 100;
    EXPECT_NE(planPasses(formPqp(8, 1.0), request, old).reason.find("ES 1.00"), std::string::npos);
    // Where no float can be drawn to, one pass is drawn and several are not.
    Capabilities bytes = modern();
    bytes.floatTargets = false;
    request.target = ColourFormat::rgba8;
    request.lights = 0;
    EXPECT_NE(planPasses(formPqp(8, 1.0), request, bytes).reason.find("float surfaces"),
              std::string::npos);
    request.technique = Technique::single;
    request.lights = 2;
    EXPECT_TRUE(planPasses(formPqp(8, 1.0), request, bytes).feasible());
    request.lobes.thetas = 0;
    EXPECT_THROW(planPasses(formPqp(8, 1.0), request, modern()), Error);
}

TEST(LobePlan, AreaLightsTakeNoLookups)
{
    PlanRequest request = twoLookup(2);
    request.lobes = tiltedLobes(3);
    request.lobeLight.areaLights = 3;
    const Plan plan = planPasses(formHdio({8, 8, 8}), request, modern());
    ASSERT_TRUE(plan.feasible()) << plan.reason;
    // The technique has one light in each pass, and all lobes of it fit.
    ASSERT_EQ(plan.passes.size(), 5u);
    for (int i = 0; i < 3; ++i) {
        const Pass& pass = plan.passes[static_cast<size_t>(2 + i)];
        EXPECT_EQ(pass.lookups, 0);
        EXPECT_EQ(pass.lobes.count, 3);
        EXPECT_EQ(pass.lobes.firstArea, i);
        EXPECT_FALSE(pass.lobes.environment);
    }
    request.technique = Technique::single;
    const Plan single = planPasses(formHdio({8, 8, 8}), request, modern());
    ASSERT_EQ(single.passes.size(), 1u);
    EXPECT_EQ(single.passes[0].lobes.areaCount, 3);
    EXPECT_EQ(single.passes[0].lobes.areaSlots, 4);
    request.lobeLight.areaLights = -1;
    EXPECT_THROW(planPasses(formHdio({8, 8, 8}), request, modern()), Error);
    request.lobeLight.areaLights = 1;
    request.lobes = {};
    EXPECT_THROW(planPasses(formHdio({8, 8, 8}), request, modern()), Error);
}

TEST(LobePlan, SpreadsManyAreaLightsOverPasses)
{
    Capabilities small = modern();
    small.maxUniformVectors = 256;
    PlanRequest request;
    request.lights = 2;
    request.lobes = tiltedLobes(2);
    request.lobeLight = {true, 70};
    const Form form = formPqp(8, 1.0);
    const Plan plan = planPasses(form, request, small);
    ASSERT_TRUE(plan.feasible()) << plan.reason;
    int areas = 0, environments = 0;
    for (const Pass& pass : plan.passes) {
        EXPECT_LE(kVectorsPerLight * pass.lightCount + pass.lobes.vectors(),
                  freeUniformVectors(form, small));
        EXPECT_GE(pass.lobes.areaSlots, pass.lobes.areaCount);
        areas += pass.lobes.areaCount;
        environments += !pass.lobes.isEmpty() && pass.lobes.environment ? 1 : 0;
    }
    EXPECT_EQ(areas, 70);
    EXPECT_EQ(environments, 1);
}

TEST(LobePlan, StatesTheErrorOfTheLobesThatAreDrawn)
{
    PlanRequest request = twoLookup(2);
    request.lobeError = 0.04;
    EXPECT_EQ(planPasses(formPqp(8, 1.0), request, modern()).lobeError, 0.0);
    request.lobes = tiltedLobes(2);
    request.lobeLight.environment = true;
    EXPECT_EQ(planPasses(formPqp(8, 1.0), request, modern()).lobeError, 0.04);
    request.lobeError = -1.0;
    EXPECT_THROW(planPasses(formPqp(8, 1.0), request, modern()), Error);
}

TEST(LobePlan, DirectionsHaveAPassOfTheirOwn)
{
    const Form form = formPqp(8, 1.0);  // three look-ups
    for (const ColourFormat target : {ColourFormat::rgba32f, ColourFormat::rgba8})
        for (const int lights : {0, 1, 9}) {
            PlanRequest request;
            request.lights = lights;
            request.target = target;
            request.lobes = bentLobes(5);
            request.lobeLight.environment = true;
            request.lobeError = 0.1;
            request.environmentSamples = 16;
            const Plan plan = planPasses(form, request, modern());
            ASSERT_TRUE(plan.feasible()) << plan.reason;
            EXPECT_EQ(plan.lobeError, 0.0);
            int sampled = 0;
            for (const Pass& pass : plan.passes) {
                if (pass.lobes.isEmpty()) continue;
                ++sampled;
                EXPECT_EQ(pass.lobes.samples, 16);
                EXPECT_EQ(pass.lobes.count, 5);
                EXPECT_TRUE(pass.parts.empty());
                EXPECT_EQ(pass.lookups, 16 * (3 + 1));
            }
            EXPECT_EQ(sampled, 1);
        }
}

TEST(LobePlan, DirectionsNeedSingleWithoutALimitAndRoomForAllLobes)
{
    const Form form = formPqp(8, 1.0);
    PlanRequest request;
    request.lights = 2;
    request.lobes = bentLobes(7);
    request.lobeLight.environment = true;
    request.environmentSamples = 16;
    Capabilities small = modern();
    small.maxUniformVectors = 256;
    EXPECT_NE(planPasses(form, request, small).reason.find("room"), std::string::npos);
    request.maxLookups = 100;
    EXPECT_NE(planPasses(form, request, modern()).reason.find("limit of look-ups"),
              std::string::npos);
    request.maxLookups = 0;
    for (const Technique technique : {Technique::batched, Technique::twoLookup}) {
        request.technique = technique;
        EXPECT_NE(planPasses(form, request, modern()).reason.find(techniqueName(technique)),
                  std::string::npos);
    }
    request.environmentSamples = -1;
    EXPECT_THROW(planPasses(form, request, modern()), Error);
    request.environmentSamples = 1;
    request.lobes = {};
    EXPECT_THROW(planPasses(form, request, modern()), Error);
}

TEST(LobePlan, FewerLobesKeepTheEnergy)
{
    LobeTable table;
    table.thetas = 2;
    table.knots.resize(2);
    for (int axes = 0; axes < 2; ++axes) {
        table.axes = axes ? LobeAxes::bent : LobeAxes::tilted;
        table.lobes = axes ? 7 : 3;
        for (size_t i = 0; i < 2; ++i)
            for (size_t k = 0; k < static_cast<size_t>(table.lobes); ++k)
                table.knots[i].lobes[k] = {Vec3f(static_cast<float>(1 + k + i)),
                                           axes ? 1.5f : static_cast<float>(k) * 0.5f,
                                           axes ? 0.0f : static_cast<float>(k)};
        table.fewerErrors.assign(2, 0.25);
        table.error = 0.125;
        for (int lobes = 1; lobes <= 4; ++lobes) {
            const LobeTable fewer = withFewerLobes(table, lobes);
            EXPECT_NO_THROW(validate(fewer, "fewer"));
            EXPECT_EQ(fewer.lobes, lobes >= 3 ? table.lobes : axes ? 2 * lobes - 1 : lobes);
            for (size_t i = 0; i < 2; ++i) {
                float all = 0.0f, kept = 0.0f;
                for (const Lobe& lobe : table.knots[i].lobes) all += lobe.weight.x;
                for (const Lobe& lobe : fewer.knots[i].lobes) kept += lobe.weight.x;
                EXPECT_EQ(kept, all);
            }
            EXPECT_EQ(fewer.error, fewer.lobes < table.lobes ? 0.25 : 0.125);
        }
    }
    // The middle one of seven bent lobes, with all the others' energy.
    EXPECT_EQ(withFewerLobes(table, 1).knots[0].lobes[0].level, 1.5f);
}

TEST(LobePlan, TheLobeThatStandsForOthersIsBetweenThem)
{
    LobeTable table;
    table.lobes = 2;
    table.thetas = 2;
    table.error = 0.5;
    table.knots.resize(2);
    for (LobeKnot& knot : table.knots)
        knot.lobes = {Lobe{Vec3f(3.0f), 1.0f, 0.0f}, Lobe{Vec3f(1.0f), 5.0f, -2.0f}};
    const LobeTable fewer = withFewerLobes(table, 1);
    const Lobe& lobe = fewer.knots[0].lobes[0];
    EXPECT_EQ(lobe.weight, Vec3f(4.0f));
    EXPECT_EQ(lobe.level, 2.0f);
    EXPECT_EQ(lobe.tilt, -0.5f);
    EXPECT_EQ(fewer.error, 0.5) << "as good as is known";
    // Black lobes are nowhere between.
    for (LobeKnot& knot : table.knots) knot.lobes[0].weight = knot.lobes[1].weight = Vec3f(0.0f);
    EXPECT_EQ(withFewerLobes(table, 1).knots[0].lobes[0].level, 1.0f);
}

}  // namespace
}  // namespace fbrdf

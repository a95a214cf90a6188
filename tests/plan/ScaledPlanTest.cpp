// Sums in RGBA8 surfaces are scaled so that nothing clips, and their errors stay within the bound
// that the plan states.
#include "PlanSimulator.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/plan/LightSelection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

/// A context that cannot draw to floats.
Capabilities old()
{
    Capabilities c;
    c.maxUniformVectors = 4096;
    c.framebufferObjects = c.floatTextures = true;
    return c;
}

/// Bounds that simulated factors and lights (times `dim`) never exceed.
Peaks peaksOf(const Form& form, int lights, double dim)
{
    Peaks peaks;
    peaks.tables.assign(form.tables.size(), 2.0);
    for (size_t t = 0; t < form.terms.size(); ++t)
        peaks.scales.push_back(simulatedScale(static_cast<int>(t)));
    peaks.lights.assign(static_cast<size_t>(lights), 2.0 * dim);
    return peaks;
}

PlanRequest requestOf(const Form& form, int lights, double dim,
                      Technique technique = Technique::twoLookup)
{
    PlanRequest request;
    request.technique = technique;
    request.lights = lights;
    request.lightsPerPass = 4;
    request.target = ColourFormat::rgba8;
    request.peaks = peaksOf(form, lights, dim);
    return request;
}

Form formSum()
{
    Form sum = formPqp(4, 1.0), other = formHdio({4, 4, 4});
    sum.name = "pqp+hdio";
    for (TableSpec& table : other.tables) sum.tables.push_back(table);
    sum.terms.push_back(other.terms[0]);
    for (Factor& factor : sum.terms.back().factors) factor.table += 2;
    return sum;
}

/// A form of three look-ups that depend on the light, which the scratch surface builds up.
Form formThree()
{
    Form form = formPqpr(4, 1.0, 4);
    form.name = "three";
    form.tables[2].uniform = false;
    return form;
}

/// The stored value of one pixel and the expected one.
struct Pixel {
    double found = 0.0, exact = 0.0;
};

Pixel pixelOf(const Form& form, const Plan& plan, int lights, double dim, unsigned seed,
              Transfer transfer)
{
    SimulatedFragment fragment = simulatedFragment(form, lights, 0.5, seed);
    for (double& irradiance : fragment.irradiance) irradiance *= dim;
    const double exact = transferred(transfer, 1.0, expectedValue(form, fragment));
    return {simulate(plan, {fragment}, {0.7, 1.0}, ColourFormat::rgba8).value,
            std::min(1.0, exact)};
}

TEST(ScaledPlan, IsWithinItsBound)
{
    double worst = 0.0;
    int scaled = 0;
    for (const Form& form : {formPqp(4, 1.0), formHdio({4, 4, 4}), formSum(), formThree()})
        for (const Technique technique : {Technique::batched, Technique::twoLookup})
            for (const Transfer transfer : {Transfer::linear, Transfer::srgb, Transfer::toneMap})
                for (const int lights : {1, 3, 9})
                    for (const double dim : {0.0004, 0.01}) {
                        PlanRequest request = requestOf(form, lights, dim, technique);
                        request.transfer = transfer;
                        const Plan plan = planPasses(form, request, old());
                        if (!plan.feasible()) continue;
                        scaled += plan.surfaces == ColourFormat::rgba8;
                        EXPECT_LE(plan.error.absolute, kCoarsestSum);
                        for (unsigned seed = 0; seed < 40; ++seed) {
                            const Pixel p = pixelOf(form, plan, lights, dim, seed, transfer);
                            const double bound =
                                plan.error.relative * p.exact + plan.error.absolute;
                            EXPECT_LE(std::abs(p.found - p.exact), bound)
                                << form.name << " " << techniqueName(technique) << " " << lights
                                << " " << dim << " transfer " << static_cast<int>(transfer);
                            worst = std::max(worst, std::abs(p.found - p.exact) / bound);
                        }
                    }
    EXPECT_GT(scaled, 40);
    EXPECT_GT(worst, 0.4) << "a bound that nothing comes near says nothing";
}

TEST(ScaledPlan, BoundsWhatItLoses)
{
    const Form form = formPqp(4, 1.0);
    const int lights = 5;
    const double dim = 0.01;
    const Plan plan = planPasses(form, requestOf(form, lights, dim), old());
    ASSERT_TRUE(plan.feasible()) << plan.reason;
    EXPECT_EQ(plan.passes.size(), 6u);
    EXPECT_LE(plan.maxLookups, 2);
    EXPECT_EQ(plan.surfaces, ColourFormat::rgba8);
    EXPECT_EQ(plan.accumulation, ColourFormat::rgba8);
    // Five steps for q p of five lights, scaled up, and one for p with the scale.
    const double sum = lights * 2.0 * dim * 4.0, uplift = sum * 2.0 * simulatedScale(0);
    // The first light is written, the others are blended, with twice the rounding.
    EXPECT_NEAR(plan.error.absolute, ((2 * lights - 1) * uplift + 1.0) / 255.0, 1e-12);
    for (size_t i = 0; i < 5; ++i) EXPECT_NEAR(plan.passes[i].gain, 1.0 / sum, 1e-12);
    EXPECT_NEAR(plan.passes.back().gain, sum, 1e-12);
}

TEST(ScaledPlan, FillsTheSurfaceAndNoMore)
{
    const Form form = formPqp(4, 1.0);
    const Plan plan = planPasses(form, requestOf(form, 4, 0.01), old());
    double sum = 0.0;
    for (const Pass& pass : plan.passes)
        if (pass.lit) sum += pass.gain * pass.largest;
    EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(ScaledPlan, IsNotMadeWhereItWouldBeNoPicture)
{
    const Form form = formPqp(4, 1.0);
    const Plan plan = planPasses(form, requestOf(form, 40, 0.1), old());
    EXPECT_FALSE(plan.feasible());
    EXPECT_NE(plan.reason.find("40 lights in RGBA8 surfaces"), std::string::npos) << plan.reason;
}

TEST(ScaledPlan, IsNotMadeWhereFloatsCanBe)
{
    Capabilities modern = old();
    modern.floatTargets = true;
    for (const Form& form : {formPqp(4, 1.0), formSum()}) {
        const Plan plan = planPasses(form, requestOf(form, 5, 0.01), modern);
        EXPECT_EQ(plan.surfaces, ColourFormat::rgba32f);
        for (const Pass& pass : plan.passes) EXPECT_EQ(pass.gain, 1.0);
    }
}

TEST(HalfPlan, IsMadeWhereHalvesCanBeDrawnToAndIsWithinItsBound)
{
    Capabilities halves = old();
    halves.halfTargets = true;
    double worst = 0.0;
    for (const Form& form : {formPqp(4, 1.0), formSum(), formThree()})
        for (const Transfer transfer : {Transfer::linear, Transfer::srgb})
            for (const int lights : {1, 3, 9, 60}) {
                PlanRequest request = requestOf(form, lights, 0.001);
                request.target = ColourFormat::rgba16f;
                request.transfer = transfer;
                // Under a curve 60 lights would be too many for halves that are taken for 0.
                for (StoreRounding& rounding : request.roundings) rounding.tiny = 0x1p-24;
                const Plan plan = planPasses(form, request, halves);
                ASSERT_TRUE(plan.feasible()) << plan.reason;
                EXPECT_LE(plan.maxLookups, 2);
                EXPECT_EQ(plan.surfaces, ColourFormat::rgba16f);
                for (unsigned seed = 0; seed < 40; ++seed) {
                    SimulatedFragment fragment = simulatedFragment(form, lights, 0.5, seed);
                    for (double& irradiance : fragment.irradiance) irradiance *= 0.001;
                    const double exact = transferred(transfer, 1.0, expectedValue(form, fragment));
                    const double bound = plan.error.relative * exact + plan.error.absolute;
                    const double found =
                        simulate(plan, {fragment}, {0.7, 1.0}, ColourFormat::rgba16f).value;
                    EXPECT_LE(std::abs(found - exact), bound)
                        << form.name << " " << lights << " lights";
                    worst = std::max(worst, std::abs(found - exact) / bound);
                }
            }
    EXPECT_GT(worst, 0.2) << "a bound that nothing comes near says nothing";
}

TEST(HalfPlan, IsNotMadeForMoreLightsThanHalvesAddUp)
{
    Capabilities halves = old();
    halves.halfTargets = true;
    const Form form = formPqp(4, 1.0);
    PlanRequest request = requestOf(form, 60, 0.001);
    EXPECT_EQ(planPasses(form, request, halves).accumulation, ColourFormat::rgba16f);
    // More of them where the context rounds as finely as halves allow.
    request = requestOf(form, 240, 0.001);
    request.roundings.fill({0.5, 0.5});
    EXPECT_EQ(planPasses(form, request, halves).accumulation, ColourFormat::rgba16f);
    request = requestOf(form, 200, 0.001);
    const Plan none = planPasses(form, request, halves);
    EXPECT_FALSE(none.feasible());
    EXPECT_NE(none.reason.find("200 lights in RGBA16F surfaces"), std::string::npos) << none.reason;
    request.technique = Technique::single;
    EXPECT_TRUE(planPasses(form, request, halves).feasible());
}

TEST(ScaledPlan, NeedsSurfacesAndPeaksAndNoSigns)
{
    const Form form = formPqp(4, 1.0);
    const PlanRequest good = requestOf(form, 5, 0.01);
    EXPECT_TRUE(planPasses(form, good, old()).feasible());
    PlanRequest request = good;
    request.offscreen = false;
    EXPECT_FALSE(planPasses(form, request, old()).feasible());
    request = good;
    request.peaks.reset();
    EXPECT_FALSE(planPasses(form, request, old()).feasible());
    request = good;
    request.signs = true;
    EXPECT_FALSE(planPasses(form, request, old()).feasible());
    Capabilities bare = old();
    bare.framebufferObjects = false;
    EXPECT_FALSE(planPasses(form, good, bare).feasible());
}

TEST(ScaledPlan, TakesTheSmallerErrorOfTheTwo)
{
    // Adding up in the target itself costs a step for each light. Lights that reach a hundredth of
    // it leave room to scale up.
    const Form form = formHdio({4, 4, 4});
    const auto surfaces = [&](double dim) {
        return planPasses(form, requestOf(form, 5, dim), old()).surfaces;
    };
    EXPECT_EQ(surfaces(0.2), ColourFormat::rgba32f);
    EXPECT_EQ(surfaces(0.0002), ColourFormat::rgba8);
}

TEST(ScaledPlan, RefusesPeaksOfSomethingElse)
{
    const Form form = formPqp(4, 1.0);
    const auto expectUsage = [&](const auto& spoil) {
        PlanRequest request = requestOf(form, 5, 0.01);
        spoil(*request.peaks);
        try {
            planPasses(form, request, old());
            FAIL() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
        }
    };
    expectUsage([](Peaks& peaks) { peaks.lights.pop_back(); });
    expectUsage([](Peaks& peaks) { peaks.tables.push_back(1.0); });
    expectUsage([](Peaks& peaks) { peaks.scales.clear(); });
    expectUsage([](Peaks& peaks) { peaks.lights[0] = std::nan(""); });
}

// The tester: without its gains a plan clips, and the comparison must notice.
TEST(ScaledPlan, WithoutGainsIsWrong)
{
    const Form form = formPqp(4, 1.0);
    Plan plan = planPasses(form, requestOf(form, 4, 0.01), old());
    ASSERT_TRUE(plan.feasible());
    for (Pass& pass : plan.passes) pass.gain = pass.lit ? 20.0 : 1.0 / 20.0;
    double worst = 0.0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Pixel p = pixelOf(form, plan, 4, 0.01, seed, Transfer::linear);
        worst = std::max(worst, std::abs(p.found - p.exact));
    }
    EXPECT_GT(worst, plan.error.absolute);
}

TEST(LargestIrradiance, IsThatOfTheLargestChannelAtTheNearestPoint)
{
    Light light;
    light.intensity = Vec3f(1.0f, 3.0f, 2.0f);
    light.position = Vec3f(0.0f, 0.0f, 4.0f);
    EXPECT_NEAR(largestIrradiance(light, {Vec3f(0.0f), 2.0f}), 3.0 / 4.0, 1e-12);
    EXPECT_NEAR(strongestIrradiance(light, {Vec3f(0.0f), 2.0f}), 2.0 / 4.0, 1e-12);
    EXPECT_GT(largestIrradiance(light, {Vec3f(0.0f), 5.0f}), 1e11);
    light.type = Light::Type::directional;
    EXPECT_NEAR(largestIrradiance(light, {Vec3f(0.0f), 2.0f}), 3.0, 1e-12);
}

}  // namespace
}  // namespace fbrdf

// Sums for a UNORM target are taken in the smallest format whose error is within the tolerance, and
// what is drawn is within the bound, however coarsely the context rounds.
#include "PlanForms.h"
#include "PlanRequests.h"
#include "PlanSimulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace fbrdf {
namespace {

// As measured where halves below the smallest normal one are kept.
constexpr StoreRounding kNearest{0.5, 0.5, 0x1p-24}, kTruncating{1.0, 1.0, 0x1p-24}, kGranted{};

Capabilities gpu()
{
    Capabilities c = modern();
    c.halfTargets = c.unorm16Targets = true;
    return c;
}

/// brightness: that of a white surface under all lights, about.
PlanRequest requestOf(const Form& form, int lights, double brightness,
                      const StoreRounding& rounding = kNearest)
{
    PlanRequest request = twoLookup(lights);
    request.target = ColourFormat::rgba8;
    request.roundings.fill(rounding);
    request.peaks = Peaks{};
    // Simulated factors and irradiances are at most 2.
    request.peaks->tables.assign(form.tables.size(), 2.0);
    for (size_t t = 0; t < form.terms.size(); ++t)
        request.peaks->scales.push_back(simulatedScale(static_cast<int>(t)));
    request.peaks->lights.assign(static_cast<size_t>(lights), 2.0 * brightness / lights);
    return request;
}

/// The largest share of the bound that is used up by any of some pixels.
double shareOfBound(const Form& form, const PlanRequest& request, const Plan& plan, Store store)
{
    double worst = 0.0;
    for (unsigned seed = 0; seed < 30; ++seed) {
        SimulatedFragment fragment = simulatedFragment(form, request.lights, 0.5, seed);
        for (double& irradiance : fragment.irradiance) irradiance *= request.peaks->lights[0] / 2.0;
        const double exact =
            std::min(1.0, transferred(request.transfer, 1.0, expectedValue(form, fragment)));
        const double found = simulate(plan, {fragment}, {0.7, 1.0}, request.target, store).value;
        worst = std::max(
            worst, std::abs(found - exact) / (plan.error.relative * exact + plan.error.absolute));
    }
    return worst;
}

TEST(SumFormat, IsTheSmallestWhoseErrorIsWithinTheTolerance)
{
    std::map<ColourFormat, int> taken;
    for (const Form& form : {formPqp(4, 1.0), formHdio({4, 4, 4})})
        for (const Transfer transfer : {Transfer::linear, Transfer::srgb})
            for (const int lights : {2, 4, 8, 16, 64})
                for (const double brightness : {0.002, 0.05, 1.0, 30.0}) {
                    PlanRequest request = requestOf(form, lights, brightness);
                    request.transfer = transfer;
                    const Plan plan = planPasses(form, request, gpu());
                    ASSERT_TRUE(plan.feasible());
                    ++taken[plan.surfaces];
                    request.accumulation = ColourFormat::rgba32f;
                    const Plan finest = planPasses(form, request, gpu());
                    EXPECT_EQ(finest.surfaces, ColourFormat::rgba32f);
                    EXPECT_EQ(plan.passes.size(), finest.passes.size());
                    const auto total = [](const Plan& of) {
                        return of.error.relative + of.error.absolute;
                    };
                    EXPECT_LE(total(plan), total(finest) + 0.5 / 255.0 + 1e-12);
                    EXPECT_NE(plan.whyAccumulation.find("allowed"), std::string::npos);
                    EXPECT_LE(shareOfBound(form, request, plan, Store::nearest), 1.0)
                        << form.name << " " << lights << " lights " << brightness << " in "
                        << colourFormatName(plan.surfaces);
                }
    for (const auto format :
         {ColourFormat::rgba8, ColourFormat::rgba16f, ColourFormat::rgba16, ColourFormat::rgba32f})
        EXPECT_GT(taken[format], 0) << colourFormatName(format);
}

TEST(SumFormat, OfFewLightsIsRgba16fAndOfManyRgba32f)
{
    const Form form = formPqp(4, 1.0);
    const Plan few = planPasses(form, requestOf(form, 3, 30.0), gpu()),
               many = planPasses(form, requestOf(form, 64, 30.0), gpu());
    EXPECT_EQ(few.accumulation, ColourFormat::rgba16f);
    EXPECT_EQ(few.whyAccumulation.rfind("RGBA16F adds up to 0.0017", 0), 0u) << few.whyAccumulation;
    EXPECT_EQ(many.accumulation, ColourFormat::rgba32f);
    EXPECT_NE(many.whyAccumulation.find("RGBA16F adds up to 0.03"), std::string::npos)
        << many.whyAccumulation;
}

TEST(SumFormat, IsRgba32fWhereNothingIsKnownOrNothingIsSaved)
{
    const Form form = formPqp(4, 1.0);
    const auto surfaces = [&](const auto& change) {
        PlanRequest request = requestOf(form, 3, 1.0);
        Capabilities capabilities = gpu();
        change(request, capabilities);
        const Plan plan = planPasses(form, request, capabilities);
        for (const Pass& pass : plan.passes) EXPECT_EQ(pass.gain, 1.0);
        return plan.surfaces;
    };
    const auto expected = ColourFormat::rgba32f;
    EXPECT_EQ(surfaces([](PlanRequest& r, Capabilities&) { r.peaks.reset(); }), expected);
    EXPECT_EQ(surfaces([](PlanRequest& r, Capabilities&) { r.target = expected; }), expected);
    EXPECT_EQ(surfaces([](PlanRequest& r, Capabilities&) { r.target = ColourFormat::rgba16f; }),
              expected);
    EXPECT_EQ(surfaces([](PlanRequest& r, Capabilities&) { r.signs = true; }), expected);
    EXPECT_EQ(surfaces([](PlanRequest&, Capabilities& c) { c.softwareSampling = true; }), expected);
    // The peak of a light in the midst of an object may be no number that one can divide by.
    EXPECT_EQ(surfaces([](PlanRequest& r, Capabilities&) {
                  r.peaks->lights[1] = std::numeric_limits<double>::infinity();
              }),
              expected);
}

TEST(SumFormat, ThatIsAskedForIsTakenWhereItsErrorIsThatOfAPicture)
{
    const Form form = formPqp(4, 1.0);
    for (const auto asked : {ColourFormat::rgba8, ColourFormat::rgba16f, ColourFormat::rgba16,
                             ColourFormat::rgba32f}) {
        PlanRequest request = requestOf(form, 9, 0.05);
        request.accumulation = asked;
        const Plan plan = planPasses(form, request, gpu());
        EXPECT_EQ(plan.surfaces, asked) << colourFormatName(asked);
        EXPECT_EQ(plan.accumulation, asked);
        EXPECT_LE(shareOfBound(form, request, plan, Store::nearest), 1.0);
    }
    PlanRequest request = requestOf(form, 64, 30.0);
    request.accumulation = ColourFormat::rgba8;
    EXPECT_EQ(planPasses(form, request, gpu()).surfaces, ColourFormat::rgba32f);
    request.accumulation = ColourFormat::rgba16;
    Capabilities embedded = gpu();
    embedded.unorm16Targets = false;
    EXPECT_EQ(planPasses(form, request, embedded).surfaces, ColourFormat::rgba32f);
}

// What contexts grant or were seen to do is within the bound of each of them; and a bound for
// contexts that round to the nearest is false where one truncates.
TEST(StoreRounding, IsPartOfTheBound)
{
    const std::pair<StoreRounding, Store> contexts[] = {
        {kNearest, Store::nearest}, {kTruncating, Store::truncates}, {kGranted, Store::coarsest}};
    double worst = 0.0, untrue = 0.0;
    for (const Form& form : {formPqp(4, 1.0), sum(formPqp(4, 1.0), formHdio({4, 4, 4}))})
        for (const auto& [rounding, store] : contexts)
            for (const auto format :
                 {ColourFormat::rgba8, ColourFormat::rgba16f, ColourFormat::rgba32f})
                for (const int lights : {1, 3, 9}) {
                    PlanRequest request = requestOf(form, lights, 0.02, rounding);
                    request.accumulation = format;
                    const Plan plan = planPasses(form, request, gpu());
                    ASSERT_TRUE(plan.feasible());
                    const double share = shareOfBound(form, request, plan, store);
                    EXPECT_LE(share, 1.0)
                        << form.name << " " << lights << " " << colourFormatName(format);
                    worst = std::max(worst, share);
                    request.roundings.fill(kNearest);
                    if (store == Store::coarsest)
                        untrue = std::max(
                            untrue,
                            shareOfBound(form, request, planPasses(form, request, gpu()), store));
                }
    EXPECT_GT(worst, 0.5) << "a bound that nothing comes near says nothing";
    EXPECT_GT(untrue, 1.0);
}

}  // namespace
}  // namespace fbrdf

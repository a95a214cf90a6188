#include "PlanRequests.h"

#include <fbrdf/base/Srgb.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

TEST(Precision, GrowsByOneRoundingAPass)
{
    const double ulp = 0x1p-23;
    const auto bound = [](int lights, ColourFormat target, Transfer transfer = Transfer::linear) {
        PlanRequest request = twoLookup(lights);
        request.target = target;
        request.transfer = transfer;
        return planPasses(formHdio({4, 4, 4}), request, modern()).error;
    };
    const ErrorBound one = bound(1, ColourFormat::rgba32f);
    // Blending rounds twice where OpenGL grants it, and once where the context was seen to.
    EXPECT_NEAR(bound(256, ColourFormat::rgba32f).relative - one.relative, 2 * 255 * ulp, 1e-12);
    EXPECT_EQ(one.absolute, 0.0);
    // A sum in a float surface is rounded to the target once, however many lights there are.
    EXPECT_EQ(bound(256, ColourFormat::rgba8).absolute, 1.0 / 255.0);
    EXPECT_NEAR(
        bound(256, ColourFormat::rgba16f).relative - bound(256, ColourFormat::rgba32f).relative,
        0x1p-10, 1.1e-4);
    const ErrorBound curved = bound(4, ColourFormat::rgba8, Transfer::srgb);
    EXPECT_EQ(curved.relative, 0.0);
    EXPECT_LT(curved.absolute, 1.1 / 255.0);
}

TEST(Precision, CountsRecombinedMapsOnce)
{
    PlanRequest request = twoLookup(4);
    const auto bound = [&request] { return planPasses(formPqp(4, 1.0), request, modern()).error; };
    const ErrorBound native = bound();
    request.maps.recombination = 0.5;
    const double factor = std::sqrt(2.0);
    EXPECT_NEAR(bound().relative, factor * (1.0 + native.relative) - 1.0, 1e-12);
    EXPECT_EQ(bound().maps.recombination, 0.5);
    request.transfer = Transfer::srgb;
    const double curved = bound().absolute;
    request.maps.recombination = 0.0;
    // How far the code of some x <= 1 can move in either direction.
    const double up = srgbFromLinear(1.0) - srgbFromLinear(1.0 / factor);
    EXPECT_GE(curved - bound().absolute, up);
    EXPECT_LT(curved - bound().absolute, 1.5 * up);
}

TEST(Precision, CountsFilteringAsRecombinationAndAddsWhatIsAbsolute)
{
    PlanRequest recombined = twoLookup(4), filtered = recombined, absolute = recombined;
    recombined.maps.recombination = filtered.maps.filtering = 0.25;
    absolute.maps.absolute = 0.01;
    const auto bound = [](const PlanRequest& request) {
        return planPasses(formPqp(4, 1.0), request, modern()).error;
    };
    const ErrorBound plain = bound(twoLookup(4));
    EXPECT_EQ(bound(filtered).relative, bound(recombined).relative);
    EXPECT_EQ(bound(filtered).maps.filtering, 0.25);
    EXPECT_EQ(bound(absolute).relative, plain.relative);
    EXPECT_NEAR(bound(absolute).absolute, plain.absolute + 0.01, 1e-12);
    absolute.transfer = Transfer::srgb;
    PlanRequest curved = twoLookup(4);
    curved.transfer = Transfer::srgb;
    EXPECT_GE(bound(absolute).absolute, bound(curved).absolute + 0.9 * srgbFromLinear(0.01));
    filtered.filter = Filter::shader;
    EXPECT_EQ(planPasses(formPqp(4, 1.0), filtered, modern()).filter, Filter::shader);
}

// GLSL 4.60, 4.7.1: exp2(x) may be off by (3 + 2 |x|) units in the last place, in every pass.
TEST(Precision, GrowsWithTheExponents)
{
    PlanRequest request = twoLookup(1);
    const auto bound = [&request] {
        return planPasses(formHdio({4, 4, 4}), request, modern()).error;
    };
    const double calm = bound().relative;
    request.maps.exponent = 20.0;
    EXPECT_NEAR(bound().relative - calm, 40.0 * 0x1p-23, 1e-12);
    Material material;
    material.form = formHdio({4, 4, 4});
    for (const TableSpec& spec : material.form.tables) {
        Table table;
        table.name = spec.name;
        table.domain = spec.domain;
        table.storage = Storage::half;
        table.texels.assign(static_cast<size_t>(3 * texelCount(table.domain)), 1.0f);
        table.texels[4] = -5.0f;
        material.tables.push_back(std::move(table));
    }
    EXPECT_EQ(largestExponent(material), 10.0);
}

// Halves below 2^-14 have fewer digits, which drivers may drop altogether.
TEST(Precision, OfHalvesCountsWhatIsTakenForZero)
{
    PlanRequest request = twoLookup(1);
    request.target = ColourFormat::rgba16f;
    request.technique = Technique::single;
    const auto bound = [&request] {
        return planPasses(formHdio({4, 4, 4}), request, modern()).error;
    };
    EXPECT_EQ(bound().absolute, 0x1p-14);
    for (StoreRounding& rounding : request.roundings) rounding.tiny = 0x1p-24;
    EXPECT_EQ(bound().absolute, 0x1p-24);
}

TEST(Precision, OfOtherFormatsIsThatOfTheirUnit)
{
    PlanRequest request = twoLookup(1);
    request.target = ColourFormat::other;
    request.technique = Technique::single;
    const auto bound = [&request] {
        return planPasses(formHdio({4, 4, 4}), request, modern()).error;
    };
    const ErrorBound bytes = bound();
    EXPECT_EQ(bytes.absolute, 1.0 / 255.0);
    request.otherUnit = {0.0, 1.0 / 31.0};
    EXPECT_EQ(bound().absolute, 1.0 / 31.0);
    request.otherUnit = {0x1p-5, 0x1p-14};
    EXPECT_NEAR(bound().relative, bytes.relative + 0x1p-5, 1e-12);
    EXPECT_EQ(bound().absolute, 0x1p-14);
}

// The mean of samples is stored once more, in floats whatever the peaks would allow.
TEST(Precision, CountsTheMeanOfSamples)
{
    PlanRequest request = twoLookup(3);
    request.target = ColourFormat::rgba8;
    request.peaks = Peaks{{1.0, 1.0}, {1.0}, {0.1, 0.1, 0.1}};
    request.roundings.fill({0.5, 0.5, 0x1p-24});
    Capabilities gpu = modern();
    gpu.unorm16Targets = true;
    const auto plan = [&] { return planPasses(formHdio({4, 4, 4}), request, gpu); };
    EXPECT_NE(plan().surfaces, ColourFormat::rgba32f);
    request.accumulation = ColourFormat::rgba32f;
    const double alone = plan().error.relative;
    request.accumulation.reset();
    request.resolves = true;
    EXPECT_EQ(plan().surfaces, ColourFormat::rgba32f);
    EXPECT_NEAR(plan().error.relative - alone, 0.5 * 0x1p-23, 1e-12);
}

TEST(Precision, NothingMultipliesInPlaceWhereFactorsAreClamped)
{
    for (const auto target : {ColourFormat::rgba8, ColourFormat::rgba16, ColourFormat::other})
        for (const bool offscreen : {true, false})
            for (const Technique technique : allTechniques()) {
                PlanRequest request;
                request.technique = technique;
                request.lights = 9;
                request.lightsPerPass = 2;
                request.target = target;
                request.offscreen = offscreen;
                for (const Pass& pass : planPasses(formPqp(4, 1.0), request, modern()).passes)
                    EXPECT_FALSE(pass.blend == Blend::multiply && pass.writes == Surface::target)
                        << techniqueName(technique) << " " << offscreen;
            }
}

}  // namespace
}  // namespace fbrdf

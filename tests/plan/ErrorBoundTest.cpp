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

TEST(Precision, NothingMultipliesInPlaceWhereFactorsAreClamped)
{
    for (const bool offscreen : {true, false})
        for (const Technique technique : allTechniques()) {
            PlanRequest request;
            request.technique = technique;
            request.lights = 9;
            request.lightsPerPass = 2;
            request.target = ColourFormat::rgba8;
            request.offscreen = offscreen;
            for (const Pass& pass : planPasses(formPqp(4, 1.0), request, modern()).passes)
                EXPECT_FALSE(pass.blend == Blend::multiply && pass.writes == Surface::target)
                    << techniqueName(technique) << " " << offscreen;
        }
}

}  // namespace
}  // namespace fbrdf

#include <fbrdf/peers/SvdBaseline.h>

#include <fbrdf/brdf/Error.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/fit/SampleSets.h>
#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

constexpr double kFloat = 1e-5;  // values pass through float

// Away from grazing, where f grows by orders of magnitude within a cell.
double squaredError(const SvdModel& model, const BrdfFunction& brdf)
{
    double sum = 0.0;
    for (const auto& pair : uniformPairs(2000, 5)) {
        if (std::min(pair.wo.z, pair.wi.z) < 0.3) continue;
        const Vec3d d = evaluate(model, pair.wo, pair.wi) - brdf(pair.wo, pair.wi);
        sum += glm::dot(d, d);
    }
    return sum;
}

TEST(SvdBaseline, OneTermHoldsALambertian)
{
    const BrdfFunction lambert = makeModelSource("lambert:albedo=0.2/0.4/0.8").evaluate;
    const SvdModel model = fitSvd(lambert, {}, 1, 1);
    for (const auto& pair : uniformPairs(200))
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(evaluate(model, pair.wo, pair.wi)[c], lambert(pair.wo, pair.wi)[c], kFloat);
}

TEST(SvdBaseline, OneTermHoldsAFunctionOfTheDifferenceVector)
{
    // Linear in theta_d: bilinear look-ups lose nothing.
    const BrdfFunction product = [](const Vec3d& wo, const Vec3d& wi) {
        return Vec3d(1.0 + halfDifferenceFromPair({wo, wi}).theta_d);
    };
    const SvdModel model = fitSvd(product, {}, 1, 1);
    for (const auto& pair : uniformPairs(200)) {
        if (std::min(pair.wo.z, pair.wi.z) < 0.3) continue;  // away from theta_d = pi/2
        EXPECT_NEAR(evaluate(model, pair.wo, pair.wi).x, product(pair.wo, pair.wi).x, kFloat);
    }
}

TEST(SvdBaseline, TermsLowerTheError)
{
    const BrdfFunction ggx = makeModelSource("ggx:alpha=0.4,f0=0.5,kd=0.2").evaluate;
    const double one = squaredError(fitSvd(ggx, {}, 1, 1), ggx);
    const double four = squaredError(fitSvd(ggx, {}, 4, 1), ggx);
    EXPECT_LT(four, 0.5 * one);
}

TEST(SvdBaseline, CountsWhatItKeeps)
{
    SvdGrid grid;
    grid.thetaH = 8;
    grid.thetaD = 4;
    grid.phiD = 6;
    const SvdModel model =
        fitSvd([](const Vec3d&, const Vec3d&) { return Vec3d(1.0); }, grid, 2, 1);
    EXPECT_EQ(bytesOf(model), 2u * 3u * 2u * (8u + 24u));
    EXPECT_EQ(model.u[0].size(), 16u);
    EXPECT_EQ(model.v[2].size(), 48u);
}

TEST(SvdBaseline, RefusesMoreTermsThanTheMatrixHas)
{
    const BrdfFunction one = [](const Vec3d&, const Vec3d&) { return Vec3d(1.0); };
    SvdGrid grid;
    grid.thetaH = 8;
    EXPECT_THROW(fitSvd(one, grid, 0, 1), Error);
    EXPECT_THROW(fitSvd(one, grid, 9, 1), Error);
}

}  // namespace
}  // namespace fbrdf

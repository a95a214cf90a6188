#include <fbrdf/peers/GgxFit.h>

#include <fbrdf/base/Error.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

// Samples are float, and least squares stops at a relative fall of 1e-6 of the cost.
constexpr double kFound = 0.02;

std::vector<Sample> samplesOf(const std::string& spec)
{
    return samplesAt(makeModelSource(spec), uniformPairs(2000, 3), 1);
}

double worstRatio(const GgxModel& model, const std::string& spec)
{
    const Source source = makeModelSource(spec);
    double worst = 0.0;
    for (const auto& pair : uniformPairs(500, 9)) {
        const Vec3d f = source.evaluate(pair.wo, pair.wi), g = evaluate(model, pair.wo, pair.wi);
        for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(std::log(g[c] / f[c])));
    }
    return worst;
}

TEST(GgxFit, FindsTheParametersOfAGgxPlastic)
{
    const std::string spec = "ggx:alpha=0.2,f0=0.04,kd=0.1/0.3/0.5";
    const GgxModel model = fitGgx(samplesOf(spec), {});
    ASSERT_EQ(model.lobes.size(), 1u);
    EXPECT_NEAR(model.lobes[0].alphaX, 0.2, kFound * 0.2);
    EXPECT_EQ(model.lobes[0].alphaX, model.lobes[0].alphaY);
    EXPECT_NEAR(model.kd.y, 0.3, kFound * 0.3);
    EXPECT_LT(worstRatio(model, spec), kFound);
}

TEST(GgxFit, FindsBothRoughnessesOfAnAnisotropicMetal)
{
    const std::string spec = "ggx:alpha_x=0.15,alpha_y=0.4,f0=0.9/0.7/0.5,kd=0.02";
    GgxFitOptions options;
    options.isotropic = false;
    const GgxModel model = fitGgx(samplesOf(spec), options);
    EXPECT_NEAR(model.lobes[0].alphaX, 0.15, kFound * 0.15);
    EXPECT_NEAR(model.lobes[0].alphaY, 0.4, kFound * 0.4);
}

TEST(GgxFit, ASecondLobeIsNoWorse)
{
    const std::string spec = "beckmann:alpha=0.25,f0=0.5,kd=0.1";
    GgxFitOptions two;
    two.lobes = 2;
    const auto samples = samplesOf(spec);
    EXPECT_LT(worstRatio(fitGgx(samples, two), spec), worstRatio(fitGgx(samples, {}), spec));
}

TEST(GgxFit, ReflectsNothingBelowTheHorizon)
{
    const GgxModel model{Vec3d(0.5), {{Vec3d(1.0), 0.04, 0.2, 0.2}}};
    EXPECT_EQ(evaluate(model, {0.0, 0.0, 1.0}, {0.8, 0.0, -0.6}), Vec3d(0.0));
    EXPECT_GT(evaluate(model, {0.0, 0.0, 1.0}, {0.8, 0.0, 0.6}).x, 0.5 / kPi);
}

TEST(GgxFit, RefusesWhatCannotBeFitted)
{
    EXPECT_THROW(fitGgx({}, {}), Error);
    GgxFitOptions three;
    three.lobes = 3;
    EXPECT_THROW(fitGgx(samplesOf("lambert"), three), Error);
}

}  // namespace
}  // namespace fbrdf

#include <fbrdf/metrics/Metrics.h>
#include <fbrdf/metrics/SampleSets.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

// Values travel as float.
constexpr double kFloat = 1e-6;

std::vector<Sample> samplesOf(const BrdfFunction& brdf, size_t count = 4096)
{
    Source source;
    source.evaluate = brdf;
    return samplesAt(source, uniformPairs(count), 0);
}

Vec3d smooth(const Vec3d& wo, const Vec3d& wi)
{
    return (0.2 + wo.z * wi.z) * Vec3d(0.5, 0.3, 0.1);
}

std::vector<Vec3f> scaled(const std::vector<Sample>& samples, const Vec3f& factor)
{
    std::vector<Vec3f> values;
    for (const Sample& s : samples) values.push_back(s.f * factor);
    return values;
}

TEST(SampleErrors, AreZeroForThePerfectFit)
{
    const auto samples = samplesOf(smooth);
    const SampleErrors errors = sampleErrors(samples, scaled(samples, Vec3f(1.0f)), Vec3f(0.0f));
    EXPECT_EQ(errors.logRms, 0.0);
    EXPECT_EQ(errors.logMedian, 0.0);
    EXPECT_EQ(errors.cosRms, 0.0);
    EXPECT_EQ(errors.cubeRootRms, 0.0);
    EXPECT_EQ(errors.nbrdfLoss, 0.0);
}

TEST(EvaluateAt, GivesTheFunctionAtTheSamplesPairs)
{
    const auto samples = samplesOf(smooth);
    const auto values = evaluateAt(smooth, samples, 2);
    ASSERT_EQ(values.size(), samples.size());
    for (size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i].x, samples[i].f.x, 1e-6f) << i;
}

TEST(SampleErrors, OfAConstantFactorAreClosedForms)
{
    const auto samples = samplesOf(smooth);
    const SampleErrors errors =
        sampleErrors(samples, scaled(samples, {1.5f, 0.5f, 1.0f}), Vec3f(0.0f));
    const double up = std::log(1.5), down = std::log(2.0);
    EXPECT_NEAR(errors.logRms, (up + down) / 3.0, kFloat);
    EXPECT_NEAR(errors.logMedian, (up + down) / 3.0, kFloat);
    EXPECT_NEAR(errors.logMedianChannel.x, up, kFloat);
    EXPECT_NEAR(errors.logMedianChannel.y, down, kFloat);
    EXPECT_NEAR(errors.logMedianChannel.z, 0.0, kFloat);
    EXPECT_NEAR(errors.cosRms, (0.5 + 0.5) / 3.0, kFloat);
    EXPECT_NEAR(errors.cubeRootRms, (std::cbrt(1.5) - 1.0 + 1.0 - std::cbrt(0.5)) / 3.0, kFloat);
}

TEST(SampleErrors, CompressedLossIsWeightedByTheCosineOfTheLight)
{
    // One sample: cos theta_i = 0.6, f = 0.5, g = 1 in all channels.
    const std::vector<Sample> one{{{0, 0, 1}, {0.8f, 0, 0.6f}, Vec3f(0.5f), 1.0f}};
    const SampleErrors errors = sampleErrors(one, {Vec3f(1.0f)}, Vec3f(0.0f));
    EXPECT_NEAR(errors.nbrdfLoss, std::log(1.6) - std::log(1.3), kFloat);
    EXPECT_NEAR(errors.cosRms, 1.0, kFloat);
}

TEST(SampleErrors, MedianOfAnEvenNumberIsTheMiddleOfTwo)
{
    std::vector<Sample> samples(4, Sample{{0, 0, 1}, {0, 0, 1}, Vec3f(1.0f), 1.0f});
    std::vector<Vec3f> fitted;
    for (const double error : {0.1, 0.2, 0.4, 5.0})
        fitted.push_back(Vec3f(static_cast<float>(std::exp(error))));
    EXPECT_NEAR(sampleErrors(samples, fitted, Vec3f(0.0f)).logMedian, 0.3, kFloat);
    samples.pop_back();
    fitted.pop_back();
    EXPECT_NEAR(sampleErrors(samples, fitted, Vec3f(0.0f)).logMedian, 0.2, kFloat);
}

TEST(SampleErrors, LogErrorsLeaveOutTheNoise)
{
    std::vector<Sample> samples(3, Sample{{0, 0, 1}, {0, 0, 1}, Vec3f(1.0f), 1.0f});
    samples[1].f = Vec3f(0.01f);
    samples[2].f = Vec3f(-0.01f);
    const std::vector<Vec3f> fitted(3, Vec3f(2.0f));
    EXPECT_NEAR(sampleErrors(samples, fitted, Vec3f(0.01f)).logRms, std::log(2.0), kFloat);
    EXPECT_GT(sampleErrors(samples, fitted, Vec3f(0.001f)).logRms, 2.0 * std::log(2.0));
}

TEST(SampleErrors, AChannelWithoutLightIsNoError)
{
    const auto samples = samplesOf([](const Vec3d&, const Vec3d&) { return Vec3d(0.5, 0.5, 0.0); });
    const SampleErrors errors = sampleErrors(samples, scaled(samples, Vec3f(2.0f)), Vec3f(0.0f));
    EXPECT_NEAR(errors.logMedian, std::log(2.0), kFloat);
    EXPECT_NEAR(errors.cosRms, 1.0, kFloat);
    EXPECT_TRUE(std::isnan(errors.logMedianChannel.z));
}

TEST(SampleErrors, ABlackFitIsVeryWrongAndFinite)
{
    const auto samples = samplesOf(smooth);
    const SampleErrors errors = sampleErrors(samples, scaled(samples, Vec3f(0.0f)), Vec3f(0.0f));
    EXPECT_GT(errors.logRms, 50.0);
    EXPECT_TRUE(std::isfinite(errors.logRms));
    EXPECT_NEAR(errors.cosRms, 1.0, kFloat);
    EXPECT_NEAR(errors.cubeRootRms, 1.0, kFloat);
}

TEST(SampleErrors, NothingMeasuredIsNotPerfect)
{
    EXPECT_TRUE(std::isnan(sampleErrors({}, {}, Vec3f(0.0f)).logRms));
    EXPECT_TRUE(std::isnan(sampleErrors({}, {}, Vec3f(0.0f)).nbrdfLoss));
}

TEST(SampleErrors, NotANumberIsInfinitelyWrong)
{
    const auto samples = samplesOf(smooth, 100);
    const std::vector<Vec3f> fitted(samples.size(), Vec3f(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_EQ(sampleErrors(samples, fitted, Vec3f(0.0f)).logMedian,
              std::numeric_limits<double>::infinity());
}

TEST(SampleErrors, EveryMetricSeesAWrongFit)
{
    const auto samples = samplesOf(smooth);
    const auto wrong =
        evaluateAt([](const Vec3d& wo, const Vec3d&) { return Vec3d(wo.z); }, samples, 0);
    for (const auto& [name, value] : named(sampleErrors(samples, wrong, Vec3f(0.0f))))
        EXPECT_GT(value, 0.05) << name;
}

TEST(Named, HasTheDocumentedNames)
{
    const auto has = [](const std::map<std::string, double>& values, const char* name) {
        return values.count(name) == 1;
    };
    for (const char* name : {"log_rms", "log_median", "cos_rms", "cuberoot_rms", "nbrdf_loss"})
        EXPECT_TRUE(has(named(SampleErrors{}), name)) << name;
    for (const char* name : {"psnr_linear", "psnr_srgb", "ssim", "delta_e_itp", "flip"})
        EXPECT_TRUE(has(named(ImageErrors{}), name)) << name;
    for (const char* name : {"reciprocity", "albedo_max"})
        EXPECT_TRUE(has(named(PhysicsErrors{}), name)) << name;
}

}  // namespace
}  // namespace fbrdf

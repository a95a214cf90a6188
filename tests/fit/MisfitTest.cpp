#include <fbrdf/metrics/Misfit.h>

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fbrdf {
namespace {

constexpr size_t kCount = 20000;

// A grey surface that reflects 0.2 everywhere, and what a fit might have made of it.
struct Case {
    std::vector<Sample> samples;
    std::vector<Vec3f> fitted;
};

Case flatCase(double noise)
{
    Case result;
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0.0, 1.0);
    for (const auto& pair : uniformPairs(kCount)) {
        const float f = static_cast<float>(0.2 * std::exp(noise * normal(random)));
        result.samples.push_back({Vec3f(pair.wo), Vec3f(pair.wi), Vec3f(f)});
        result.fitted.push_back(Vec3f(0.2f));
    }
    return result;
}

HalfDifference anglesOf(const Sample& sample)
{
    return halfDifferenceFromPair({Vec3d(sample.wo), Vec3d(sample.wi)});
}

bool isRetro(const Sample& sample)
{
    return anglesOf(sample).theta_d < kRetroAngle * kPi / 180.0;
}

std::vector<MisfitRegion> regionsOf(const Case& c, bool exact = false)
{
    return misfitRegions(c.samples, c.fitted, Vec3f(0.0f), exact);
}

TEST(Misfit, NoiseAloneIsNone)
{
    EXPECT_TRUE(regionsOf(flatCase(0.0)).empty());
    EXPECT_TRUE(regionsOf(flatCase(0.8)).empty());  // a factor of 2.2 either way, without structure
    EXPECT_FALSE(regionsOf(flatCase(0.8), true).empty());  // functions have no noise
}

TEST(Misfit, WhatNeighboursShareIsNamedWithItsChannels)
{
    Case c = flatCase(0.3);
    for (size_t i = 0; i < kCount; ++i)
        if (isRetro(c.samples[i])) c.samples[i].f.y *= 20.0f;
    const auto regions = regionsOf(c);
    ASSERT_FALSE(regions.empty());
    for (const MisfitRegion& r : regions) {
        EXPECT_EQ(r.theta_dTo, kRetroAngle);
        EXPECT_FALSE(r.channels[0] || r.channels[2]);
        EXPECT_TRUE(r.channels[1]);
        EXPECT_NEAR(r.factor, 20.0, 3.0);
        EXPECT_NEAR(r.bias, 0.05, 0.01);
        const std::string text = describe(r);
        EXPECT_NE(text.find("theta_d 0 to 5 degrees"), std::string::npos) << text;
        EXPECT_NE(text.find(", G: off by a factor of"), std::string::npos) << text;
        EXPECT_NE(text.find("too dark"), std::string::npos) << text;
    }
    EXPECT_NE(describe(regions[0]).find("back towards the light"), std::string::npos);
}

TEST(Misfit, WhatAlternatesWithAzimuthIsStructureToo)
{
    Case c = flatCase(0.1);
    for (Sample& s : c.samples)
        s.f *= static_cast<float>(std::exp(1.2 * std::cos(2.0 * anglesOf(s).phi_h)));
    EXPECT_GE(regionsOf(c).size(), 4u);
}

TEST(Misfit, SpikesAndValuesInTheNoiseAccuseNobody)
{
    Case c = flatCase(0.1);
    for (size_t i = 0; i < kCount; i += 300) c.samples[i].f *= 8.0f;
    EXPECT_TRUE(regionsOf(c).empty());
    for (size_t i = 0; i < kCount; ++i)
        if (isRetro(c.samples[i])) c.fitted[i] *= 10.0f;
    EXPECT_FALSE(regionsOf(c).empty());
    EXPECT_TRUE(misfitRegions(c.samples, c.fitted, Vec3f(0.1f), false).empty());
}

FitOptions named(const char* form)
{
    FitOptions options;
    options.form = form;
    options.heldOut = false;
    options.smoothness = 1e-4;
    options.threads = 1;
    return options;
}

Source scatteredOf(const BrdfFunction& brdf, double noise)
{
    Source source;
    source.name = "scattered";
    source.evaluate = brdf;
    source.samples = samplesAt(source, uniformPairs(kCount), 1);
    source.evaluate = {};
    std::mt19937 random(3);
    std::normal_distribution<float> normal;
    for (Sample& s : source.samples)
        s.f *= 1.0f + std::max(-0.9f, static_cast<float>(noise) * normal(random));
    return source;
}

TEST(Misfit, PqpCannotRepresentARetroReflector)
{
    const auto tape = [](const Vec3d& wo, const Vec3d& wi) {
        const double theta_d = halfDifferenceFromPair({wo, wi}).theta_d * 180.0 / kPi;
        return Vec3d(0.1 + 4.0 * std::exp(-theta_d * theta_d / 8.0));
    };
    const FitResult pqp = fitMaterial(scatteredOf(tape, 0.05), named("pqp"));
    ASSERT_FALSE(pqp.summary.misfits.empty());
    EXPECT_EQ(pqp.summary.misfits[0].theta_dTo, kRetroAngle);
    EXPECT_TRUE(fitMaterial(scatteredOf(tape, 0.05), named("hdio")).summary.misfits.empty());
}

TEST(Misfit, HdioCannotRepresentAnisotropy)
{
    const BrdfFunction brushed = makeModelSource("ggx:alpha_x=0.1,alpha_y=0.5,f0=0.9").evaluate;
    EXPECT_FALSE(fitMaterial(scatteredOf(brushed, 0.05), named("hdio")).summary.misfits.empty());
    EXPECT_TRUE(fitMaterial(scatteredOf(brushed, 0.05), named("pqpr")).summary.misfits.empty());
}

TEST(Misfit, NoisyDataOfASuitableFormArePassed)
{
    for (const char* model : {"ggx:alpha=0.1,f0=0.04,kd=0.3", "ggx:alpha=0.05,f0=0.9", "lambert"})
        for (const double noise : {0.0, 0.1, 0.3}) {
            const BrdfFunction brdf = makeModelSource(model).evaluate;
            const auto summary = fitMaterial(scatteredOf(brdf, noise), named("hdio")).summary;
            EXPECT_TRUE(summary.misfits.empty())
                << model << " " << noise << " " << describe(summary.misfits[0]);
        }
}

Sample sampleAt(double theta_i, double phi_i, double theta_o, double phi_o)
{
    return {Vec3f(directionFromAngles(theta_o * kDegree, phi_o * kDegree)),
            Vec3f(directionFromAngles(theta_i * kDegree, phi_i * kDegree)), Vec3f(1.0f)};
}

TEST(CoverageOf, KnowsThePlaneOfIncidence)
{
    std::vector<Sample> samples;
    for (int i = 5; i <= 75; i += 10)
        for (int o = -80; o <= 80; o += 5) samples.push_back(sampleAt(i, 30, o, 30));
    const Coverage plane = coverageOf(samples);
    EXPECT_TRUE(plane.inPlane);
    EXPECT_TRUE(plane.oneAzimuth);
    EXPECT_EQ(plane.incidences, 8u);
    EXPECT_NEAR(plane.theta_iFrom, 5.0, 1e-3);
    EXPECT_NEAR(plane.theta_iTo, 75.0, 1e-3);
    EXPECT_NE(describe(plane).find("in the plane of incidence only"), std::string::npos);
    for (int i = 5; i <= 75; i += 10) samples.push_back(sampleAt(i, 30, 50, 90));
    EXPECT_FALSE(coverageOf(samples).inPlane);
    samples.push_back(sampleAt(40, 60, 50, 90));
    EXPECT_FALSE(coverageOf(samples).oneAzimuth);
    EXPECT_EQ(describe(coverageOf(samples)).find("plane"), std::string::npos);
}

TEST(CoverageOf, KnowsASingleIncidence)
{
    const std::vector<Sample> samples{sampleAt(45, 0, 10, 20), sampleAt(45, 0, 30, 70)};
    EXPECT_NE(describe(coverageOf(samples)).find("45 degrees alone"), std::string::npos);
    EXPECT_FALSE(fitMaterial(makeModelSource("lambert"), named("io")).summary.coverage);
}

}  // namespace
}  // namespace fbrdf

// Data made worse on purpose, and fits to them: small versions of `fbrdf bench-fit --robustness`.
#include <fbrdf/fit/Disturb.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/fit/NoiseFloor.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/sources/Model.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

std::vector<Sample> samplesOf(const std::string& model, size_t count)
{
    return samplesAt(makeModelSource(model), uniformPairs(count, 1), 1);
}

TEST(Disturb, IsWhatItSays)
{
    const auto clean = samplesOf("lambert:albedo=0.5", 40000);
    const auto noisy = withNoise(clean, {0.1, 0.0, 0.01, 0.003, 8.0}, 5);
    const double f = static_cast<double>(clean[0].f.x);
    double zeros = 0, spikes = 0, sum = 0, squares = 0, count = 0;
    for (const Sample& s : noisy) {
        const double ratio = static_cast<double>(s.f.x) / f;
        if (ratio == 0.0) ++zeros;
        if (ratio > 4.0) ++spikes;
        if (ratio == 0.0 || ratio > 4.0) continue;
        ++count;
        sum += ratio - 1.0;
        squares += (ratio - 1.0) * (ratio - 1.0);
    }
    const double n = static_cast<double>(noisy.size());
    EXPECT_NEAR(zeros / n, 0.01, 4.0 * std::sqrt(0.01 / n));
    EXPECT_NEAR(spikes / n, 0.003, 4.0 * std::sqrt(0.003 / n));
    EXPECT_NEAR(sum / count, 0.0, 4.0 * 0.1 / std::sqrt(n));
    EXPECT_NEAR(std::sqrt(squares / count), 0.1, 0.002);
}

TEST(Disturb, PicksAsManyAsAskedInTheirOrder)
{
    const auto all = samplesOf("lambert", 1000);
    const auto part = randomPart(all, 100, 3);
    ASSERT_EQ(part.size(), 100u);
    size_t at = 0;
    for (const Sample& s : part) {
        while (at < all.size() && !(all[at].wo == s.wo)) ++at;
        ASSERT_LT(at, all.size());
    }
    EXPECT_EQ(randomPart(all, 5000, 3).size(), all.size());
    EXPECT_NE(randomPart(all, 100, 4)[0].wo, randomPart(all, 100, 5)[0].wo);
}

TEST(NoiseModel, KnowsWhetherNoiseFollowsTheCosine)
{
    auto dark = samplesOf("lambert:albedo=0.005", 30000);
    for (size_t i = 0; i < dark.size(); ++i)
        if (i % 4 != 0) dark[i].f = Vec3f(0.5f);  // most of any measurement lies above its noise
    const NoiseModel radiance = estimateNoise(withNoise(dark, {0.0, 0.01, 0.0, 0.0, 1.0}, 2));
    EXPECT_TRUE(radiance.overCosine);
    EXPECT_TRUE(radiance.unclipped);
    EXPECT_NEAR(radiance.sigma.x, 0.01f, 0.0015f);
    auto even = dark;  // the same noise at every angle
    const auto noisy = withNoise(dark, {0.0, 0.01, 0.0, 0.0, 1.0}, 2);
    for (size_t i = 0; i < dark.size(); ++i)
        even[i].f = dark[i].f + (noisy[i].f - dark[i].f) * dark[i].wi.z;
    EXPECT_FALSE(estimateNoise(even).overCosine);
    EXPECT_NEAR(estimateNoise(even).sigma.x, 0.01f, 0.0015f);
    EXPECT_FALSE(estimateNoise(dark).unclipped);
}

Material fitted(const std::vector<Sample>& samples)
{
    Source source;
    source.name = "measured";
    source.isotropic = true;
    source.samples = samples;
    FitOptions options;
    options.form = "hdio";
    options.maxBytes = 600;
    options.heldOut = false;
    options.threads = 1;
    return fitMaterial(source, options).material;
}

double psnrOf(const std::vector<Sample>& samples, const std::string& model)
{
    constexpr int kSize = 64;
    const Material material = fitted(samples);
    const auto fit = [&](const Vec3d& wo, const Vec3d& wi) { return evaluate(material, wo, wi); };
    return imageErrors(renderStandardSphere(fit, kSize, 1),
                       renderStandardSphere(makeModelSource(model).evaluate, kSize, 1))
        .psnrLinear;
}

// What lies in the noise is right on average, although no logarithm of half of it exists.
TEST(Robust, ADarkSurfaceUnderNoiseIsNotMadeBrighter)
{
    const auto dark = samplesOf("lambert:albedo=0.015", 60000);
    const double f = static_cast<double>(dark[0].f.x);  // 0.0048: sigma is 0.004 and more
    const Material material = fitted(withNoise(dark, {}, 3));
    double sum = 0.0, count = 0.0;
    for (const auto& pair : uniformPairs(2000)) {
        if (std::min(pair.wo.z, pair.wi.z) < 0.3) continue;
        sum += evaluate(material, pair.wo, pair.wi).x;
        ++count;
    }
    EXPECT_NEAR(sum / count / f, 1.0, 0.03);
}

TEST(Robust, NoiseZerosAndSpikesLeaveThePicture)
{
    const std::string plastic = "ggx:alpha=0.3,f0=0.04,kd=0.05";
    EXPECT_GT(psnrOf(withNoise(samplesOf(plastic, 60000), {}, 3), plastic), 58.0);
}

TEST(Robust, ATenthOfTheSamplesCostsNextToNothing)
{
    const std::string plastic = "ggx:alpha=0.3,f0=0.04,kd=0.05";
    const auto all = samplesOf(plastic, 60000);
    EXPECT_GT(psnrOf(randomPart(all, all.size() / 10, 4), plastic), psnrOf(all, plastic) - 1.0);
}

}  // namespace
}  // namespace fbrdf

#include <fbrdf/fit/NoiseFloor.h>

#include <gtest/gtest.h>

#include <random>

namespace fbrdf {
namespace {

std::vector<Sample> noisy(float sigma, bool clipped)
{
    std::mt19937 random(5);
    std::normal_distribution<float> noise(0.0f, sigma);
    std::vector<Sample> samples;
    for (int i = 0; i < 20000; ++i) {
        const float truth = i % 4 == 0 ? 0.0f : 0.5f;  // a quarter of the values lies in the dark
        float f = truth + noise(random);
        if (clipped && f < 0.0f) f = 0.0f;
        samples.push_back({Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(f), 1.0f});
    }
    return samples;
}

TEST(NoiseFloor, IsZeroForCleanData)
{
    std::vector<Sample> samples(10, Sample{Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(0.2f), 1.0f});
    EXPECT_EQ(estimateNoiseFloor(samples), Vec3f(0.0f));
}

TEST(NoiseFloor, NegativeValuesGiveSigma)
{
    // The rms of a half normal is sigma; 2,500 negatives leave 3 %.
    EXPECT_NEAR(estimateNoiseFloor(noisy(0.01f, false)).x, 0.01f, 0.0006f);
}

TEST(NoiseFloor, ClippedZerosGiveTheOrderOfSigma)
{
    const float floor = estimateNoiseFloor(noisy(0.01f, true)).x;
    EXPECT_GT(floor, 0.01f);
    EXPECT_LT(floor, 0.06f);
}

TEST(NoiseFloor, NeverExceedsTheMedianOfThePositiveValues)
{
    std::vector<Sample> samples(90, Sample{Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(0.0f), 1.0f});
    for (int i = 0; i < 10; ++i) samples[size_t(i)].f = Vec3f(1.0f + float(i));
    EXPECT_LE(estimateNoiseFloor(samples).x, 6.0f);
}

}  // namespace
}  // namespace fbrdf

#include <fbrdf/fit/NoiseFloor.h>

#include <gtest/gtest.h>

#include <cmath>
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

// A paint whose blue the primaries cannot show, seen from a grid of directions.
std::vector<Sample> outOfGamut(float sigma)
{
    std::mt19937 random(7);
    std::normal_distribution<float> noise(0.0f, 1.0f);
    std::vector<Sample> samples;
    for (int i = 0; i < 2000; ++i) {
        const float theta = 1.5f * float(i % 40) / 40.0f, phi = 6.28f * float(i / 40) / 50.0f;
        const Vec3f wo(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                       std::cos(theta));
        const float body = 0.5f + 0.1f * wo.x, blue = wo.y > 0.9f ? 0.3f : -0.1f * body;
        samples.push_back(
            {wo, Vec3f(0, 0, 1), {body, 0.8f * body, blue + sigma * noise(random)}, 1.0f});
    }
    return samples;
}

TEST(NoiseFloor, ColoursOutsideTheGamutAreNoNoise)
{
    // Neighbours differ by 0.01 of noise, and by less of their own.
    EXPECT_NEAR(estimateNoiseFloor(outOfGamut(0.01f)).z, 0.01f, 0.002f);
    // Without noise the floor is what no one sees: 0.004 of the median of red.
    EXPECT_NEAR(estimateNoiseFloor(outOfGamut(0.0f)).z, 0.002f, 0.0003f);
}

TEST(NoiseFloor, RepeatedMeasurementsOfTheDarkAreNoise)
{
    // Of a black surface as many values are below 0 as above, each beside any other.
    std::vector<Sample> samples = noisy(0.01f, false);
    for (size_t i = 0; i < samples.size(); ++i)
        samples[i].wo = glm::normalize(Vec3f(float(i % 100) / 100.0f, 0.0f, 1.0f));
    EXPECT_NEAR(estimateNoiseFloor(samples).x, 0.01f, 0.0006f);
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

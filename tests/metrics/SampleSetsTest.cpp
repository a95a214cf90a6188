#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/metrics/SampleSets.h>
#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

constexpr size_t kCount = 65536;
// Means over 32,768 low-discrepancy points; the 2 degree cut moves them by its share of the
// hemisphere (0.12 %).
constexpr double kMean = 5e-3;

TEST(UniformPairs, AreUnitAndAboveTwoDegrees)
{
    const auto pairs = uniformPairs(kCount);
    ASSERT_EQ(pairs.size(), kCount);
    for (const auto& pair : pairs)
        for (const Vec3d& w : {pair.wo, pair.wi}) {
            EXPECT_NEAR(glm::length(w), 1.0, 1e-12);
            EXPECT_GT(w.z, std::sin(kMinElevation));
        }
}

TEST(UniformPairs, FirstHalfIsCosineDistributed)
{
    // Density cos / pi: E[cos] = 2/3, E[cos^2] = 1/2, no mean direction sideways.
    const auto pairs = uniformPairs(kCount);
    Vec3d sum(0.0), squares(0.0);
    for (size_t i = 0; i < kCount / 2; ++i)
        for (const Vec3d& w : {pairs[i].wo, pairs[i].wi}) {
            sum += w / static_cast<double>(kCount);
            squares += w * w / static_cast<double>(kCount);
        }
    EXPECT_NEAR(sum.z, 2.0 / 3.0, kMean);
    EXPECT_NEAR(squares.z, 0.5, kMean);
    EXPECT_NEAR(squares.x, 0.25, kMean);
    EXPECT_NEAR(sum.x, 0.0, kMean);
    EXPECT_NEAR(sum.y, 0.0, kMean);
}

// Share of the second half with theta_h below a bound and theta_d below 0.2.
double shareBelow(double theta_h)
{
    const auto pairs = uniformPairs(kCount);
    size_t below = 0, near = 0;
    for (size_t i = kCount / 2; i < kCount; ++i) {
        const HalfDifference a = halfDifferenceFromPair(pairs[i]);
        if (a.theta_d > 0.2 || a.theta_h > 1.0) continue;
        ++near;
        if (a.theta_h < theta_h) ++below;
    }
    return static_cast<double>(below) / static_cast<double>(near);
}

TEST(UniformPairs, SecondHalfIsUniformInSqrtThetaH)
{
    // With theta_d <= 0.2 and theta_h <= 1 no pair is cut off, so shares are those of sqrt(theta_h
    // / 1).
    EXPECT_NEAR(shareBelow(0.25), 0.5, 2e-2);
    EXPECT_NEAR(shareBelow(0.01), 0.1, 1e-2);
}

TEST(UniformPairs, SeedsGiveOtherPairsAndTheSameSeedTheSame)
{
    const auto a = uniformPairs(256, 1), b = uniformPairs(256, 1), c = uniformPairs(256, 2);
    size_t same = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].wo, b[i].wo);
        if (a[i].wo == c[i].wo) ++same;
    }
    EXPECT_EQ(same, 0u);
}

TEST(SamplesAt, HoldTheSourcesValues)
{
    Source source;
    source.evaluate = [](const Vec3d& wo, const Vec3d& wi) { return Vec3d(wo.z, wi.z, wo.x); };
    const auto pairs = uniformPairs(3000);
    const auto samples = samplesAt(source, pairs, 3);
    ASSERT_EQ(samples.size(), pairs.size());
    for (size_t i = 0; i < samples.size(); ++i) {
        EXPECT_EQ(samples[i].f, Vec3f(Vec3d(pairs[i].wo.z, pairs[i].wi.z, pairs[i].wo.x)));
        EXPECT_EQ(samples[i].wi, Vec3f(pairs[i].wi));
        EXPECT_EQ(samples[i].weight, 1.0f);
    }
}

}  // namespace
}  // namespace fbrdf

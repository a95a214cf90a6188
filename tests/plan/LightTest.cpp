#include <fbrdf/brdf/Error.h>
#include <fbrdf/plan/Light.h>
#include <fbrdf/plan/Plan.h>

#include <gtest/gtest.h>

#include <limits>

namespace fbrdf {
namespace {

constexpr double kTight = 1e-14;  // a few operations in double

TEST(Falloff, IsInverseSquareWithoutARadius)
{
    EXPECT_DOUBLE_EQ(falloff(4.0, 0.0), 0.25);
    EXPECT_FLOAT_EQ(falloff(0.25f, 0.0f), 4.0f);
}

TEST(Falloff, IsWindowedToZeroAtTheRadius)
{
    EXPECT_EQ(falloff(9.0, 3.0), 0.0);
    EXPECT_EQ(falloff(10.0, 3.0), 0.0);
    EXPECT_GT(falloff(8.99, 3.0), 0.0);
    // Karis' window by hand at half the radius: 1 - (1/2)^4 = 15/16, squared.
    EXPECT_NEAR(falloff(2.25, 3.0), 225.0 / 256.0 / 2.25, kTight);
}

TEST(Falloff, FallsWithDistance)
{
    for (double d2 = 0.01; d2 < 9.0; d2 *= 1.1)
        EXPECT_GT(falloff(d2, 3.0), falloff(d2 * 1.1, 3.0)) << d2;
}

TEST(Falloff, StaysFiniteOnTheLight)
{
    EXPECT_TRUE(std::isfinite(falloff(0.0f, 0.0f)));
    EXPECT_TRUE(std::isfinite(falloff(0.0, 1.0)));
}

TEST(LightValidity, RejectsWhatIsNotANumberAndNegativeRadii)
{
    EXPECT_TRUE(isValid(Light{}));
    Light light;
    light.position.y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(isValid(light));
    light = {};
    light.intensity.z = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(isValid(light));
    light = {};
    light.radius = -1.0f;
    EXPECT_FALSE(isValid(light));
    light.radius = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(isValid(light));
}

TEST(TechniqueNames, RoundTrip)
{
    for (const Technique t : {Technique::single, Technique::batched, Technique::twoLookup})
        EXPECT_EQ(techniqueFromName(techniqueName(t)), t);
    EXPECT_THROW(techniqueFromName("deferred"), Error);
    EXPECT_THROW(techniqueFromName(""), Error);
}

}  // namespace
}  // namespace fbrdf

#include <fbrdf/base/Error.h>
#include <fbrdf/plan/LightVectors.h>
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

Light spot(float inner, float outer)
{
    Light light;
    light.type = Light::Type::spot;
    light.axis = {0.0f, 0.0f, -2.0f};
    light.innerAngle = inner;
    light.outerAngle = outer;
    return light;
}

/// The direction to the light from a point that lies at `angle` from its axis.
Vec3d towards(double angle)
{
    return {std::sin(angle), 0.0, std::cos(angle)};
}

TEST(Spot, IsFullInsideAndBlackOutside)
{
    const Light light = spot(0.3f, 0.6f);
    for (double angle = 0.0; angle < 0.3; angle += 0.05)
        EXPECT_EQ(coneFactor(light, towards(angle)), 1.0) << angle;
    for (double angle = 0.61; angle < kPi; angle += 0.05)
        EXPECT_EQ(coneFactor(light, towards(angle)), 0.0) << angle;
    // Worked out by hand: half way between the cosines a quarter remains.
    const double between = std::acos(0.5 * (std::cos(0.3) + std::cos(0.6)));
    EXPECT_NEAR(coneFactor(light, towards(between)), 0.25, 1e-6);  // the angles are floats
}

TEST(Spot, AHardEdgeStaysFinite)
{
    const Light light = spot(0.5f, 0.5f);
    EXPECT_EQ(coneFactor(light, towards(0.49)), 1.0);
    EXPECT_EQ(coneFactor(light, towards(0.51)), 0.0);
    EXPECT_TRUE(std::isfinite(coneFactor(light, towards(0.5))));
}

TEST(Spot, OtherLightsHaveNoCone)
{
    Light light = spot(0.1f, 0.2f);
    for (const auto type : {Light::Type::point, Light::Type::directional}) {
        light.type = type;
        EXPECT_EQ(coneFactor(light, towards(1.0)), 1.0);
    }
}

TEST(LightValidity, RejectsConesOutOfRange)
{
    EXPECT_TRUE(isValid(spot(0.0f, static_cast<float>(kPi))));
    EXPECT_FALSE(isValid(spot(0.5f, 0.4f)));
    EXPECT_FALSE(isValid(spot(-0.1f, 0.4f)));
    EXPECT_FALSE(isValid(spot(0.1f, 3.2f)));
    EXPECT_FALSE(isValid(spot(0.1f, std::numeric_limits<float>::quiet_NaN())));
    Light light = spot(0.1f, 0.2f);
    light.axis = Vec3f(0.0f);
    EXPECT_FALSE(isValid(light));
}

TEST(LightVectors, AreInEyeSpaceAndNormalised)
{
    glm::dmat4 toEye(1.0);  // a quarter turn about y, then 5 along -z
    toEye[0] = {0.0, 0.0, -1.0, 0.0};
    toEye[2] = {1.0, 0.0, 0.0, 0.0};
    toEye[3] = {0.0, 0.0, -5.0, 1.0};
    Light light = spot(0.0f, static_cast<float>(kPi / 2));
    light.position = {1.0f, 2.0f, 3.0f};
    light.radius = 2.0f;
    const LightVectors v = lightVectors(light, toEye);
    EXPECT_EQ(v[0], glm::vec4(3.0f, 2.0f, -6.0f, 0.25f));
    EXPECT_EQ(v[1], glm::vec4(1.0f, 1.0f, 1.0f, 1.0f));
    EXPECT_NEAR(glm::distance(v[2], glm::vec4(-1.0f, 0.0f, 0.0f, 0.0f)), 0.0f, 1e-6f);
    light.type = Light::Type::directional;
    light.position = {0.0f, 0.0f, 8.0f};
    const LightVectors directional = lightVectors(light, toEye);
    EXPECT_EQ(directional[0], glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
    EXPECT_EQ(directional[1].w, 0.0f);
    EXPECT_EQ(directional[2], glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
}

}  // namespace
}  // namespace fbrdf

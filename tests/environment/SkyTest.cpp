#include <fbrdf/environment/Sky.h>

#include <gtest/gtest.h>

#include "environment/Panoramas.h"
#include "SkyModels.h"
#include "support/ExpectError.h"

#include <cmath>

namespace fbrdf {
namespace {

double luminance(const Vec3d& colour)
{
    return glm::dot(Vec3d(0.2126, 0.7152, 0.0722), colour);
}

/// Irradiance of a surface that faces up, texel by texel at their centres.
Vec3d irradianceFromAbove(const Panorama& panorama)
{
    Vec3d sum(0.0);
    for (int y = 0; y < panorama.height / 2; ++y)
        for (int x = 0; x < panorama.width; ++x)
            sum += texelSolidAngle(panorama, y) * std::cos(kPi * (y + 0.5) / panorama.height) *
                   Vec3d(panorama.texel(x, y));
    return sum;
}

TEST(Sky, MakesAWhiteSurfaceThatFacesUpOne)
{
    constexpr double kCentres = 0.002;  // texels are not at their centres alone
    for (const std::string& name : proceduralEnvironments())
        for (const int width : {64, 256}) {
            const Panorama panorama = proceduralEnvironment(name, width);
            ASSERT_EQ(panorama.width, width);
            ASSERT_EQ(panorama.height, width / 2);
            validate(panorama, name);
            EXPECT_NEAR(luminance(irradianceFromAbove(panorama)) / kPi, 1.0, kCentres) << name;
        }
}

TEST(Sky, IsTheSameEachTime)
{
    for (const std::string& name : proceduralEnvironments())
        EXPECT_EQ(proceduralEnvironment(name, 64).texels, proceduralEnvironment(name, 64).texels);
}

TEST(Sky, KnowsItsNames)
{
    EXPECT_TRUE(isProceduralEnvironment("clear"));
    EXPECT_FALSE(isProceduralEnvironment("Clear"));
    EXPECT_FALSE(isProceduralEnvironment(""));
    test::expectError(ErrorKind::usage, "found \"dusk\", expected studio, overcast or clear",
                      [] { proceduralEnvironment("dusk"); });
    for (const int width : {-4, 0, 2, 66, 32768})
        test::expectError(ErrorKind::usage, std::to_string(width),
                          [&] { proceduralEnvironment("studio", width); });
}

TEST(Sky, OvercastIsThreeTimesAsBrightAboveAsAtTheHorizon)
{
    EXPECT_DOUBLE_EQ(overcastLuminance({0, 1, 0}), 1.0);
    EXPECT_DOUBLE_EQ(overcastLuminance({1, 0, 0}), 1.0 / 3.0);
    // Its irradiance is 7 pi / 9 of the luminance of the zenith.
    const Panorama panorama = proceduralEnvironment("overcast", 256);
    EXPECT_NEAR(double(panorama.texel(9, 0).x), 9.0 / 7.0, 0.001);
    const double lowest = (1.0 + 2.0 * std::sin(kPi / 256)) / 3.0;  // of a row of pi / 128
    EXPECT_NEAR(double(panorama.texel(9, 63).x), 9.0 / 7.0 * lowest, 0.001);
}

TEST(Sky, GroundReflectsAFifth)
{
    constexpr double kCentres = 0.002;
    for (const char* name : {"overcast", "clear"}) {
        const Panorama panorama = proceduralEnvironment(name, 128);
        const Vec3d expected = 0.2 / kPi * irradianceFromAbove(panorama);
        for (const int x : {0, 50, 127})
            for (const int y : {32, 63})
                EXPECT_NEAR(glm::distance(Vec3d(panorama.texel(x, y)) / expected, Vec3d(1.0)), 0.0,
                            kCentres)
                    << name;
    }
}

TEST(Sky, ClearHasASunOfTheSameEnergyAtEverySize)
{
    // The sun over the sky beside it, integrated: texels of the sky alone are some hundreds of
    // times darker than those of the sun.
    double before = 0.0;
    for (const int width : {128, 256, 512}) {
        const Panorama panorama = proceduralEnvironment("clear", width);
        double sun = 0.0, sky = 0.0;
        for (int y = 0; y < panorama.height / 2; ++y)
            for (int x = 0; x < width; ++x) {
                const double light = luminance(Vec3d(panorama.texel(x, y)));
                (light > 20.0 ? sun : sky) += texelSolidAngle(panorama, y) *
                                              std::cos(kPi * (y + 0.5) / panorama.height) * light;
            }
        // At 42 degrees through air of turbidity 3 some two thirds are direct.
        EXPECT_GT(sun, 1.5 * sky);
        EXPECT_LT(sun, 4.0 * sky);
        EXPECT_NEAR(sun / (before > 0.0 ? before : sun), 1.0, 0.02) << width;
        before = sun;
    }
}

TEST(Sky, ClearIsBlueAboveAndBrightBesideTheSun)
{
    const ClearSky sky{glm::normalize(Vec3d(0.0, 1.0, 1.0)), 3.0};
    const Vec3d away = sky.radiance(glm::normalize(Vec3d(0.0, 1.0, -1.0)));
    EXPECT_GT(away.z, 1.5 * away.x);
    const Vec3d beside = sky.radiance(glm::normalize(Vec3d(0.1, 1.0, 1.0)));
    EXPECT_GT(luminance(beside), 3.0 * luminance(away));
    // Table 2 of Preetham et al. is in kcd/m^2: a clear zenith has a few.
    const double zenith = luminance(sky.radiance({0, 1, 0}));
    EXPECT_GT(zenith, 2.0);
    EXPECT_LT(zenith, 10.0);
    // The sun is yellower through more air, and some 70 to 100 klx.
    const double high = luminance(ClearSky{{0, 1, 0}, 3.0}.sunIrradiance());
    const Vec3d low = ClearSky{glm::normalize(Vec3d(0, 0.1, 1)), 3.0}.sunIrradiance();
    EXPECT_GT(high, 70.0);
    EXPECT_LT(high, 115.0);
    EXPECT_LT(luminance(low), 0.6 * high);
    EXPECT_LT(low.z, 0.7 * low.x);
}

TEST(Sky, StudioHasSoftEdges)
{
    // From one texel to the next of a coarse picture light changes by less than a third of a box.
    const Panorama panorama = proceduralEnvironment("studio", 512);
    double most = 0.0;
    for (const Vec3f& texel : panorama.texels) most = std::max(most, luminance(Vec3d(texel)));
    double step = 0.0;
    for (int y = 30; y < 225; ++y)
        for (int x = 1; x < 512; ++x)
            step = std::max(step, std::abs(luminance(Vec3d(panorama.texel(x, y)) -
                                                     Vec3d(panorama.texel(x - 1, y)))));
    EXPECT_GT(most, 5.0);
    EXPECT_LT(step, 0.35 * most);
}

}  // namespace
}  // namespace fbrdf

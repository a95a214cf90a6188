#include <fbrdf/environment/Panorama.h>

#include <gtest/gtest.h>

#include "environment/Panoramas.h"
#include "support/ExpectError.h"

#include <cmath>
#include <limits>

namespace fbrdf {
namespace {

constexpr double kTight = 1e-14;      // some roundings of double
constexpr double kRoundTrip = 1e-12;  // of angles up to pi, by sines and atan2

void expectDirection(const Vec3d& found, const Vec3d& expected)
{
    EXPECT_NEAR(glm::distance(found, expected), 0.0, kTight)
        << found.x << " " << found.y << " " << found.z;
}

TEST(Panorama, HasUpAboveAndMinusZInTheMiddle)
{
    expectDirection(panoramaDirection(0.5, 0.0), {0, 1, 0});
    expectDirection(panoramaDirection(0.25, 1.0), {0, -1, 0});
    expectDirection(panoramaDirection(0.5, 0.5), {0, 0, -1});
    expectDirection(panoramaDirection(0.75, 0.5), {1, 0, 0});
    expectDirection(panoramaDirection(0.25, 0.5), {-1, 0, 0});
    expectDirection(panoramaDirection(0.0, 0.5), {0, 0, 1});
    expectDirection(panoramaDirection(1.0, 0.5), {0, 0, 1});
}

TEST(Panorama, PlacesAndDirectionsAreInverse)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int i = 0; i < 2000; ++i) {
        const double u = uniform(random), v = uniform(random);
        const Vec3d direction = panoramaDirection(u, v);
        EXPECT_NEAR(glm::length(direction), 1.0, kTight);
        const auto place = panoramaPlace((0.1 + 10.0 * uniform(random)) * direction);
        EXPECT_NEAR(place.x, u, kRoundTrip / std::sin(kPi * v));
        EXPECT_NEAR(place.y, v, kRoundTrip);
    }
}

TEST(Panorama, PolesAreInTheMiddle)
{
    for (const double x : {0.0, -0.0})
        for (const double z : {0.0, -0.0}) {
            EXPECT_EQ(panoramaPlace({x, 1.0, z}).x, 0.5);
            EXPECT_EQ(panoramaPlace({x, 1.0, z}).y, 0.0);
            EXPECT_EQ(panoramaPlace({x, -3.0, z}).x, 0.5);
            EXPECT_EQ(panoramaPlace({x, -3.0, z}).y, 1.0);
        }
}

TEST(Panorama, SolidAnglesAddUpToTheSphere)
{
    for (const auto& [width, height] : {std::pair(1, 1), {2, 1}, {7, 5}, {128, 64}, {512, 2048}}) {
        const Panorama panorama = constantPanorama(width, height, Vec3f(1.0f));
        double sum = 0.0;
        for (int y = 0; y < height; ++y) sum += width * texelSolidAngle(panorama, y);
        EXPECT_NEAR(sum, 4.0 * kPi, 1e-11) << width << " x " << height;
    }
}

Vec3d lightOf(const Panorama& panorama)
{
    Vec3d sum(0.0);
    for (int y = 0; y < panorama.height; ++y)
        for (int x = 0; x < panorama.width; ++x)
            sum += texelSolidAngle(panorama, y) * Vec3d(panorama.texel(x, y));
    return sum;
}

TEST(Panorama, LosesNoLightWhereItIsMadeSmaller)
{
    const Panorama large = randomPanorama(60, 30, 1);
    for (const int most : {1, 7, 20, 45, 60, 100}) {
        const Panorama small = reduced(large, most);
        EXPECT_EQ(small.width, std::min(most, 60));
        EXPECT_EQ(small.height, std::min(most, 30));
        // Rows that are cut are shared by angle; else floats are rounded.
        const double tolerance = 30 % small.height == 0 ? 1e-5 : 1e-3;
        EXPECT_NEAR(glm::distance(lightOf(small), lightOf(large)), 0.0, tolerance) << most;
    }
    EXPECT_EQ(reduced(large, 60).texels, large.texels);
}

TEST(Panorama, RefusesWhatIsNoLight)
{
    const Panorama good = randomPanorama(4, 2, 1);
    validate(good, "sky");
    Panorama few = good;
    few.texels.pop_back();
    const auto expectRefused = [](const Panorama& panorama, const std::string& words) {
        test::expectError(ErrorKind::input, words, [&] { validate(panorama, "sky"); });
    };
    expectRefused(few, "sky: found 7 texels for a panorama of 4 x 2");
    expectRefused({}, "sky: found 0 texels");
    expectRefused({-1, -1, {Vec3f(1.0f)}}, "-1 x -1");
    for (const float bad : {-1.0f, std::numeric_limits<float>::infinity(), std::nanf("")})
        for (int channel = 0; channel < 3; ++channel) {
            Panorama wrong = good;
            wrong.texels[6][channel] = bad;
            expectRefused(wrong, "column 2 of row 1");
        }
}

}  // namespace
}  // namespace fbrdf

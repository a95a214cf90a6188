#include "viewer/HeatScale.h"

#include <gtest/gtest.h>
#include <cmath>

namespace fbrdf::viewer {
namespace {

float lightness(const Vec3f& c)
{
    return std::cbrt(0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z);
}

TEST(HeatScale, GetsLighterFromBlackOn)
{
    EXPECT_EQ(heatColour(0.0f), Vec3f(0.0f));
    float before = -1.0f;
    for (int i = 0; i <= 100; ++i) {
        const float now = lightness(heatColour(static_cast<float>(i) / 100.0f));
        EXPECT_GT(now, before) << i;
        before = now;
    }
    EXPECT_GT(before, 0.95f);
    EXPECT_EQ(heatColour(7.0f), heatColour(1.0f));
    EXPECT_EQ(heatColour(-1.0f), Vec3f(0.0f));
}

TEST(HeatScale, ShowsTheLargestDifferenceOfWhatIsShown)
{
    scene::Image image(3, 1), reference(3, 1);
    for (int x = 0; x < 3; ++x)
        for (int c = 0; c < 3; ++c) reference.pixel(x, 0)[c] = image.pixel(x, 0)[c] = 0.25f;
    image.pixel(1, 0)[2] = 0.3f;
    image.pixel(2, 0)[0] = 7.0f;  // brighter than white
    const scene::Image map = heatMap(image, reference, 2.0f);
    EXPECT_EQ(map.pixel(0, 0)[0], 0.0f);
    const float difference =
        static_cast<float>(scene::srgbCode(0.6f) - scene::srgbCode(0.5f)) / 255.0f;
    EXPECT_NEAR(map.pixel(1, 0)[0], heatColour(difference / kHottest).x, 1e-6f);
    EXPECT_EQ(map.pixel(2, 0)[1], heatColour(1.0f).y);
    EXPECT_EQ(map.pixel(0, 0)[3], 1.0f);
}

}  // namespace
}  // namespace fbrdf::viewer

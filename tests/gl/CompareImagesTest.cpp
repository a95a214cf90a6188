// Tests the comparison of images itself: pictures that differ must be noticed.
#include "support/gl/CompareImages.h"

#include <gtest/gtest.h>

#include <limits>

namespace fbrdf::test {
namespace {

TEST(CompareImages, EqualImagesDoNotDiffer)
{
    const std::vector<float> image{0.0f, 1.0f, 2.0f};
    const ImageDifference d = compareImages(image, image);
    EXPECT_TRUE(d.comparable);
    EXPECT_EQ(d.maxRelative, 0.0);
}

TEST(CompareImages, FindsTheWorstNumber)
{
    const std::vector<double> expected{1.0, 2.0, 4.0};
    const ImageDifference d = compareImages(std::vector<double>{1.1, 2.0, 4.2}, expected);
    EXPECT_NEAR(d.maxRelative, 0.1, 1e-12);
    EXPECT_EQ(d.worst, 0u);
    EXPECT_NEAR(d.meanRelative, (0.1 + 0.05) / 3.0, 1e-12);
}

TEST(CompareImages, SeesOnePixelInFourThousand)
{
    std::vector<float> image(4 * 64 * 64, 1.0f);
    const std::vector<float> expected = image;
    image[5000] = 1.01f;
    EXPECT_GT(compareImages(image, expected).maxRelative, 0.009);
}

TEST(CompareImages, SeesLightWhereNoneShouldBe)
{
    std::vector<float> image(100, 0.0f), expected = image;
    expected[3] = 1.0f;
    image[3] = 1.0f;
    image[4] = 0.1f;
    EXPECT_GT(compareImages(image, expected).maxRelative, 1.0);
}

TEST(CompareImages, RefusesWhatCannotBeCompared)
{
    EXPECT_FALSE(compareImages(std::vector<float>{1.0f}, std::vector<float>{}).comparable);
    EXPECT_FALSE(compareImages(std::vector<float>{}, std::vector<float>{}).comparable);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(
        compareImages(std::vector<float>{nan, 1.0f}, std::vector<float>{1.0f, 1.0f}).comparable);
}

}  // namespace
}  // namespace fbrdf::test

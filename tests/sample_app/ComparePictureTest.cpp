// ComparePictureTest.cpp - pictures laid over each other, pixel by pixel. They are too small for
// labels.
#include "viewer/ComparePicture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fbrdf::viewer {
namespace {

using scene::CompareMode;

constexpr int kWidth = 16, kHeight = 12;

scene::Image grey(float value, float coverage = 1.0f)
{
    scene::Image image(kWidth, kHeight);
    for (size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = i % 4 == 3 ? coverage : value;
    return image;
}

/// All codes that there are.
scene::Image ramp()
{
    scene::Image image = grey(0.0f);
    for (size_t i = 0; i < image.rgba.size(); ++i)
        if (i % 4 != 3)
            image.rgba[i] = static_cast<float>(i) / static_cast<float>(image.rgba.size());
    return image;
}

std::vector<uint8_t> written(const scene::Image& composed)
{
    return srgbCodes(composed, 1.0f, Transfer::srgb);
}

TEST(ComparePicture, APictureWithItselfIsThatPicture)
{
    for (const Transfer transfer : {Transfer::srgb, Transfer::toneMap}) {
        const ComparePair pair{ramp(), ramp(), {1.7f, transfer}, "a", "b", ""};
        const std::vector<uint8_t> codes = srgbCodes(pair.a, 1.7f, transfer);
        for (const CompareMode mode : {CompareMode::split, CompareMode::wipe, CompareMode::flip})
            EXPECT_EQ(written(composed(pair, {mode, 0.3f})), codes);
        for (const CompareMode mode : {CompareMode::difference, CompareMode::heat})
            EXPECT_EQ(written(composed(pair, {mode, 0.5f, 64.0f})),
                      std::vector<uint8_t>(codes.size(), 0));
    }
}

TEST(ComparePicture, ASplitHasAToTheLeftOfItsLine)
{
    const ComparePair pair{grey(0.1f), grey(0.6f), {}, "a", "b", ""};
    const auto a = scene::srgbCode(0.1f), b = scene::srgbCode(0.6f);
    for (const float at : {0.0f, 0.25f, 1.0f}) {
        const std::vector<uint8_t> codes = written(composed(pair, {CompareMode::split, at}));
        for (int x = 0; x < kWidth; ++x)
            EXPECT_EQ(codes[3 * static_cast<size_t>(x)],
                      static_cast<float>(x) < at * kWidth ? a : b)
                << at << " " << x;
    }
    EXPECT_EQ(written(composed(pair, {CompareMode::flip, 0.5f, 1.0f, true}))[0], b);
    const scene::Image both = sideBySide(pair);
    EXPECT_EQ(both.width, 2 * kWidth);
    EXPECT_EQ(written(both)[0], a);
    EXPECT_EQ(written(both)[3 * kWidth], b);
}

TEST(ComparePicture, ADifferenceIsOfCodesTimesTheGain)
{
    const ComparePair pair{grey(0.5f), grey(0.52f), {}, "a", "b", ""};
    const int off = scene::srgbCode(0.52f) - scene::srgbCode(0.5f);
    ASSERT_GT(off, 0);
    EXPECT_EQ(written(composed(pair, {CompareMode::difference, 0.5f, 1.0f}))[0], off);
    EXPECT_EQ(written(composed(pair, {CompareMode::difference, 0.5f, 8.0f}))[0], 8 * off);
    EXPECT_EQ(written(composed(pair, {CompareMode::difference, 0.5f, 64.0f}))[0],
              std::min(255, 64 * off));
}

TEST(ComparePicture, NumbersAreOfWhatIsShownAndCovered)
{
    const scene::CompareNumbers equal = compareNumbers(ramp(), ramp(), {});
    EXPECT_EQ(equal.psnrLinear, std::numeric_limits<double>::infinity());
    EXPECT_EQ(equal.flip, 0.0);
    EXPECT_EQ(equal.deltaEItp, 0.0);
    EXPECT_EQ(equal.largest, 0.0);
    EXPECT_EQ(numbersText(equal), "no difference");
    const scene::CompareNumbers tenth = compareNumbers(grey(0.2f), grey(0.25f), {2.0f});
    EXPECT_NEAR(tenth.psnrLinear, 20.0, 1e-3);
    EXPECT_NEAR(tenth.largest, 0.1, 1e-6);
    EXPECT_EQ(tenth.pixels, kWidth * kHeight);
    // Both are white.
    EXPECT_EQ(compareNumbers(grey(3.0f), grey(5.0f), {}).largest, 0.0);
    EXPECT_GT(compareNumbers(grey(3.0f), grey(3.5f), {1.0f, Transfer::toneMap}).largest, 0.0);
    EXPECT_EQ(compareNumbers(grey(0.0f, 0.0f), grey(0.0f, 0.0f), {}).pixels, 0);
    EXPECT_EQ(compareNumbers(grey(0.0f, 0.0f), grey(0.1f), {}).pixels, kWidth * kHeight)
        << "what one of them covers counts";
}

}  // namespace
}  // namespace fbrdf::viewer

// SrgbTest.cpp - the curve against IEC 61966-2-1, and against its inverse.
#include <fbrdf/base/Srgb.h>
#include <gtest/gtest.h>

#include <limits>

namespace fbrdf {
namespace {

constexpr double kTight = 1e-12;  // a few operations and a pow in double
// The published pair of curves meets at 0.04045 to this much only.
constexpr double kSeam = 1e-7;

TEST(Srgb, EncodesTheStandardsValues)
{
    EXPECT_EQ(srgbFromLinear(0.0), 0.0);
    EXPECT_NEAR(srgbFromLinear(1.0), 1.0, kTight);
    EXPECT_NEAR(srgbFromLinear(0.001), 0.01292, kTight);
    EXPECT_NEAR(srgbFromLinear(0.2158605), 0.5019608, 1e-6);  // code 128 of 255
    // Both branches meet to the digits that the standard gives.
    EXPECT_NEAR(srgbFromLinear(0.0031308), srgbFromLinear(0.00313081), 1e-6);
}

TEST(Srgb, DecodingInvertsEncoding)
{
    for (int i = 0; i <= 1000; ++i) {
        EXPECT_NEAR(linearFromSrgb(srgbFromLinear(i / 1000.0)), i / 1000.0, kSeam) << i;
        EXPECT_NEAR(srgbFromLinear(linearFromSrgb(i / 1000.0)), i / 1000.0, kSeam * 12.92) << i;
    }
}

TEST(Srgb, ClampsWhatIsOutside)
{
    EXPECT_EQ(srgbFromLinear(-1.0), 0.0);
    EXPECT_NEAR(srgbFromLinear(7.0), 1.0, kTight);
    EXPECT_EQ(linearFromSrgb(-0.5), 0.0);
    EXPECT_NEAR(linearFromSrgb(1.5), 1.0, kTight);
    EXPECT_TRUE(std::isnan(srgbFromLinear(std::numeric_limits<double>::quiet_NaN())));
}

TEST(Srgb, FloatAgreesWithDouble)
{
    for (float x = 0.0f; x <= 1.0f; x += 0.001f) {
        EXPECT_NEAR(double(srgbFromLinear(x)), srgbFromLinear(double(x)), 1e-6) << x;
        EXPECT_NEAR(double(linearFromSrgb(x)), linearFromSrgb(double(x)), 1e-6) << x;
    }
}

}  // namespace
}  // namespace fbrdf

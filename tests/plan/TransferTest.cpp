#include <fbrdf/plan/Transfer.h>

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

constexpr double kTight = 1e-12;  // a few operations and a pow in double

TEST(Transfer, ToneMappingStartsAsTheIdentityAndEndsAtWhite)
{
    EXPECT_EQ(toneMapped(0.0), 0.0);
    EXPECT_NEAR(toneMapped(1e-6) / 1e-6, 1.0, 1e-5);
    EXPECT_EQ(toneMapped(4.0), 1.0);
    EXPECT_EQ(toneMapped(400.0), 1.0);
    EXPECT_NEAR(toneMapped(1.0), 17.0 / 32.0, kTight);
    EXPECT_EQ(toneMapped(-1.0), 0.0);  // a pole of the formula
    for (double x = 0.01; x < 4.0; x *= 1.2) EXPECT_GT(toneMapped(x), toneMapped(x / 1.2)) << x;
}

TEST(Transfer, ExposureScalesAllButLinear)
{
    EXPECT_EQ(transferred(Transfer::linear, 3.0, 0.25), 0.25);
    EXPECT_EQ(transferred(Transfer::exposure, 3.0, 0.25), 0.75);
    EXPECT_EQ(transferred(Transfer::srgb, 3.0, 0.25), srgbFromLinear(0.75));
    EXPECT_NEAR(transferred(Transfer::srgb, 3.0, 9.0), 1.0, kTight);
    EXPECT_EQ(transferred(Transfer::toneMap, 3.0, 0.25), srgbFromLinear(toneMapped(0.75)));
}

}  // namespace
}  // namespace fbrdf

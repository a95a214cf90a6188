#include <fbrdf/metrics/Colour.h>
#include <gtest/gtest.h>

namespace fbrdf {
namespace {

constexpr double kTight = 1e-12;
// The published inverse pair of IEC 61966-2-1 meets at 0.04045 to this much only.
constexpr double kSrgbSeam = 1e-7;

TEST(Srgb, EncodesTheStandardsValues)
{
    EXPECT_DOUBLE_EQ(srgbFromLinear(0.0), 0.0);
    EXPECT_NEAR(srgbFromLinear(1.0), 1.0, kTight);
    EXPECT_NEAR(srgbFromLinear(0.001), 0.01292, kTight);
    EXPECT_NEAR(srgbFromLinear(0.2158605), 0.5019608, 1e-6);  // code 128 of 255
}

TEST(Srgb, ClampsWhatItCannotHold)
{
    EXPECT_EQ(srgbFromLinear(-1.0), 0.0);
    EXPECT_NEAR(srgbFromLinear(7.0), 1.0, kTight);
    EXPECT_EQ(linearFromSrgb(-0.5), 0.0);
}

TEST(Srgb, DecodingInvertsEncoding)
{
    for (int i = 0; i <= 1000; ++i)
        EXPECT_NEAR(linearFromSrgb(srgbFromLinear(i / 1000.0)), i / 1000.0, kSrgbSeam) << i;
}

// Expected values: BT.2100 Table 4 in 30 digits.
TEST(Pq, MatchesTheStandardsFormula)
{
    EXPECT_NEAR(pqFromLuminance(100.0), 0.508078421517394855, kTight);
    EXPECT_NEAR(pqFromLuminance(203.0), 0.580688881041607838, kTight);
    EXPECT_NEAR(pqFromLuminance(1000.0), 0.751827096247041773, kTight);
    EXPECT_NEAR(pqFromLuminance(10000.0), 1.0, kTight);
}

// Expected values: BT.2087, BT.2100 and BT.2124 in 30 digits.
TEST(Itp, MatchesAColourComputedByHand)
{
    const Vec3d itp = itpFromLinear({0.8, 0.4, 0.1});
    EXPECT_NEAR(itp.x, 0.501147301601891303, kTight);
    EXPECT_NEAR(itp.y, -0.063123080775559248, kTight);
    EXPECT_NEAR(itp.z, 0.074747119657179351, kTight);
}

TEST(Itp, GreysHaveNoColour)
{
    for (const double grey : {0.0, 0.01, 0.5, 1.0}) {
        const Vec3d itp = itpFromLinear(Vec3d(grey));
        EXPECT_NEAR(itp.y, 0.0, kTight) << grey;
        EXPECT_NEAR(itp.z, 0.0, kTight) << grey;
    }
}

TEST(DeltaEItp, MatchesPairsComputedByHand)
{
    const auto difference = [](const Vec3d& a, const Vec3d& b) {
        return deltaEItp(itpFromLinear(a), itpFromLinear(b));
    };
    EXPECT_NEAR(difference(Vec3d(1.0), Vec3d(0.0)), 418.095468061707787, 1e-9);
    EXPECT_NEAR(difference({0.8, 0.4, 0.1}, {0.78, 0.42, 0.1}), 4.501945055927890, 1e-9);
    EXPECT_NEAR(difference({1, 0, 0}, {0, 1, 0}), 256.672220313900302, 1e-9);
}

}  // namespace
}  // namespace fbrdf

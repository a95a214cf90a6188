#include <fbrdf/metrics/Colour.h>
#include <fbrdf/plan/Transfer.h>
#include <gtest/gtest.h>

namespace fbrdf {
namespace {

constexpr double kTight = 1e-12;

// A second curve of the same name would make this call depend on the headers around it.
TEST(Srgb, IsOneCurveInEveryUnit)
{
    for (const double x : {-1.0, 0.0, 0.2, 1.0, 7.0}) {
        EXPECT_EQ(srgbFromLinear(x), srgbFromLinear<double>(x)) << x;
        EXPECT_EQ(transferred(Transfer::srgb, 1.0, x), srgbFromLinear(x)) << x;
    }
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

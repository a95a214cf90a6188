#include "ColourMap.h"

#include <gtest/gtest.h>

namespace fbrdf {
namespace {

// The polynomial against the published table.
constexpr double kPolynomial = 0.02;

void expectColour(double t, int r, int g, int b)
{
    const Vec3d colour = viridis(t);
    EXPECT_NEAR(colour.x, r / 255.0, kPolynomial) << t;
    EXPECT_NEAR(colour.y, g / 255.0, kPolynomial) << t;
    EXPECT_NEAR(colour.z, b / 255.0, kPolynomial) << t;
}

TEST(Viridis, MatchesTheTable)
{
    expectColour(0.0, 68, 1, 84);
    expectColour(64.0 / 255.0, 58, 82, 139);
    expectColour(128.0 / 255.0, 32, 144, 140);
    expectColour(192.0 / 255.0, 94, 201, 97);
    expectColour(1.0, 253, 231, 36);
}

TEST(Viridis, LumaGrows)
{
    double last = -1.0;
    for (int i = 0; i <= 100; ++i) {
        const Vec3d c = viridis(i / 100.0);
        const double luma = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
        EXPECT_GT(luma, last) << i;
        last = luma;
    }
}

TEST(Viridis, ClampsItsArgument)
{
    EXPECT_EQ(viridis(-3.0), viridis(0.0));
    EXPECT_EQ(viridis(7.0), viridis(1.0));
}

TEST(HexColour, RoundsToCodes)
{
    EXPECT_EQ(hexColour({0.0, 0.5, 1.0}), "#0080ff");
    EXPECT_EQ(hexColour({-1.0, 2.0, 0.04}), "#00ff0a");
}

}  // namespace
}  // namespace fbrdf

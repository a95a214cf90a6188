#include "formats/RglWarp.h"

#include <gtest/gtest.h>

#include <cmath>

using fbrdf::RglWarp;
using fbrdf::SliceMix;
using Point = fbrdf::Vec2<double>;

namespace {

// kFloat: densities and their integrals are stored as float.
constexpr double kFloat = 1e-6;
// kRoundTrip: where a density is 50 times below its mean, an error of float in the integral moves
// the point 50 times as far.
constexpr double kRoundTrip = 1e-4;

SliceMix only(size_t slice)
{
    return {{slice, slice, slice, slice}, {1.0, 0.0, 0.0, 0.0}};
}

/// Points of the additive recurrence of the plastic number: even over the square.
Point point(int index)
{
    const double x = 0.5 + index * 0.7548776662466927, y = 0.5 + index * 0.5698402909980532;
    return {x - std::floor(x), y - std::floor(y)};
}

std::vector<float> bumpyDensity(size_t width, size_t height)
{
    std::vector<float> density;
    for (size_t i = 0; i < width * height; ++i)
        density.push_back(0.02f + float(std::pow(std::sin(double(i) * 1.7), 2.0)));
    return density;
}

}  // namespace

TEST(RglWarp, ConstantDensityIsTheIdentity)
{
    const RglWarp warp(std::vector<float>(6 * 4, 3.0f), 6, 4);
    for (int i = 0; i < 100; ++i) {
        const Point p = point(i);
        EXPECT_LT(glm::length(warp.invert(only(0), p) - p), kFloat);
        EXPECT_LT(glm::length(warp.sample(0, p) - p), kFloat);
    }
}

TEST(RglWarp, LinearDensityInvertsToItsIntegral)
{
    // Density 2 x: the integral up to x is x^2.
    const RglWarp warp({0.0f, 2.0f, 0.0f, 2.0f}, 2, 2);
    for (int i = 0; i < 100; ++i) {
        const Point p = point(i);
        EXPECT_LT(glm::length(warp.invert(only(0), p) - Point(p.x * p.x, p.y)), kFloat);
        EXPECT_LT(glm::length(warp.sample(0, p) - Point(std::sqrt(p.x), p.y)), kFloat);
    }
}

TEST(RglWarp, SampleInvertsInvert)
{
    const RglWarp warp(bumpyDensity(9, 7), 9, 7);
    for (int i = 0; i < 2000; ++i) {
        const Point p = point(i);
        EXPECT_LT(glm::length(warp.sample(0, warp.invert(only(0), p)) - p), kRoundTrip) << i;
        EXPECT_LT(glm::length(warp.invert(only(0), warp.sample(0, p)) - p), kRoundTrip) << i;
    }
}

TEST(RglWarp, MovesAreaByTheDensity)
{
    const size_t width = 9, height = 7;
    const std::vector<float> density = bumpyDensity(width, height);
    const RglWarp warp(density, width, height);
    double whole = 0.0;  // mean of a bilinear function: its nodes, those of the border half
    for (size_t y = 0; y < height; ++y)
        for (size_t x = 0; x < width; ++x)
            whole += double(density[y * width + x]) * (x == 0 || x + 1 == width ? 0.5 : 1.0) *
                     (y == 0 || y + 1 == height ? 0.5 : 1.0);
    whole /= double((width - 1) * (height - 1));
    constexpr double kStep = 1e-3;
    for (int i = 0; i < 50; ++i) {
        const Point p = point(i) * (1.0 - 2.0 * kStep) + kStep;
        const auto at = [&](double x, double y) { return warp.invert(only(0), p + Point(x, y)); };
        const Point dx = (at(kStep, 0) - at(-kStep, 0)) / (2 * kStep);
        const Point dy = (at(0, kStep) - at(0, -kStep)) / (2 * kStep);
        const double expected = fbrdf::bilinear(density.data(), width, height, p.x, p.y) / whole;
        EXPECT_NEAR(std::abs(dx.x * dy.y - dx.y * dy.x), expected, 0.02 * expected + 0.01) << i;
    }
}

TEST(RglWarp, SlicesAreMixedByTheirWeights)
{
    // 1 and 2 x: half of each is the density 1/2 + x, with the integral x/2 + x^2/2.
    const RglWarp warp({1, 1, 1, 1, 0, 2, 0, 2}, 2, 2);
    const SliceMix half = {{0, 1, 0, 0}, {0.5, 0.5, 0.0, 0.0}};
    EXPECT_NEAR(warp.invert(half, {0.4, 0.3}).x, 0.2 + 0.08, kFloat);
}

TEST(RglWarp, KnowsSlicesWithoutDensity)
{
    const RglWarp warp({0, 0, 0, 0, 1, 1, 1, 1, -1, -1, -1, -1}, 2, 2);
    EXPECT_FALSE(warp.isValid(0));
    EXPECT_TRUE(warp.isValid(1));
    EXPECT_FALSE(warp.isValid(2));
}

TEST(RglWarp, PositionsStayInside)
{
    for (const double u : {-3.0, 0.0, 0.5, 1.0, 7.0}) {
        const fbrdf::GridPosition position = fbrdf::gridPosition(u, 5);
        EXPECT_LE(position.at, 3u);
        EXPECT_GE(position.blend, 0.0);
        EXPECT_LE(position.blend, 1.0);
    }
}

// Expected numbers: the paper's equations as direct two-dimensional sums in double (numpy), from
// which this project's separable float filters must not differ.
#include "FlipMetric.h"

#include <fbrdf/brdf/Conventions.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fbrdf {
namespace {

constexpr int kSize = 40;
// Float filters of 21 x 21 weights, then a square root near 0 in the feature part.
constexpr float kFloatFilters = 2e-4f;

template <class Colour>
RgbPlanes picture(const Colour& colour, int size = kSize)
{
    RgbPlanes planes{Plane(size, size), Plane(size, size), Plane(size, size)};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            for (int c = 0; c < 3; ++c)
                planes[static_cast<size_t>(c)].row(y)[x] = static_cast<float>(colour(x, y)[c]);
    return planes;
}

RgbPlanes uniform(const Vec3d& colour)
{
    return picture([&](int, int) { return colour; });
}

RgbPlanes waves()
{
    return picture([](int x, int y) {
        return Vec3d(0.5 + 0.5 * std::sin(0.3 * x), 0.5 + 0.5 * std::cos(0.2 * y),
                     ((x + y) % 7) / 7.0);
    });
}

RgbPlanes shiftedWaves()
{
    return picture([](int x, int y) {
        return Vec3d(0.5 + 0.5 * std::sin(0.3 * x + 0.2), 0.5 + 0.45 * std::cos(0.2 * y),
                     ((x + y) % 7) / 7.0 * (x > 20 && y > 20 ? 0.5 : 1.0));
    });
}

double mean(const Plane& plane)
{
    return std::accumulate(plane.values.begin(), plane.values.end(), 0.0) /
           static_cast<double>(plane.values.size());
}

TEST(FlipMetric, IdenticalPicturesDifferNowhere)
{
    const Plane map = flipMap(waves(), waves());
    for (const float v : map.values) EXPECT_EQ(v, 0.0f);
}

TEST(FlipMetric, WhiteAgainstBlackIsTheRemappedLightness)
{
    // HyAB = 100 and c_max = 41.2766: 0.95 + 0.05 (100^0.7 - 0.4 c_max) / (0.6 c_max); no features
    // anywhere.
    const Plane map = flipMap(uniform(Vec3d(1.0)), uniform(Vec3d(0.0)));
    for (const float v : map.values) EXPECT_NEAR(v, 0.96737918f, 1e-5f);
}

TEST(FlipMetric, GreenAgainstBlueIsTheLargestDifference)
{
    const Plane map = flipMap(uniform({0, 1, 0}), uniform({0, 0, 1}));
    for (const float v : map.values) EXPECT_NEAR(v, 1.0f, 1e-4f);
}

TEST(FlipMetric, MatchesDirectSummationOnAPattern)
{
    const Plane map = flipMap(waves(), shiftedWaves());
    EXPECT_NEAR(mean(map), 0.300577072, 1e-4);
    EXPECT_NEAR(map.row(5)[5], 0.164027370f, kFloatFilters);
    EXPECT_NEAR(map.row(22)[20], 0.333463042f, kFloatFilters);
    EXPECT_NEAR(map.row(30)[33], 0.523996795f, kFloatFilters);
    EXPECT_NEAR(map.row(0)[39], 0.270402332f, kFloatFilters);
}

TEST(FlipMetric, MatchesDirectSummationOnOneWhitePixel)
{
    const auto dot = [](int x, int y) { return Vec3d(x == 20 && y == 20 ? 1.0 : 0.0); };
    const Plane map = flipMap(picture(dot), uniform(Vec3d(0.0)));
    EXPECT_NEAR(map.row(20)[20], 0.865040869f, kFloatFilters);
    EXPECT_NEAR(map.row(20)[24], 0.017979115f, kFloatFilters);
    EXPECT_NEAR(mean(map), 0.008941872, 1e-4);
}

TEST(FlipMetric, IsSymmetricAndBounded)
{
    const Plane forth = flipMap(waves(), shiftedWaves()), back = flipMap(shiftedWaves(), waves());
    EXPECT_EQ(forth.values, back.values);
    EXPECT_GE(*std::min_element(forth.values.begin(), forth.values.end()), 0.0f);
    EXPECT_LE(*std::max_element(forth.values.begin(), forth.values.end()), 1.0f);
}

TEST(FlipMetric, AFeatureMakesADifferenceWorse)
{
    // The same amount of grey: once everywhere, once as an edge.
    const Plane flat = flipMap(uniform(Vec3d(0.5)), uniform(Vec3d(0.6)));
    const auto edge = [](int x, int) { return Vec3d(x < kSize / 2 ? 0.5 : 0.6); };
    const Plane step = flipMap(picture(edge), uniform(Vec3d(0.5)));
    EXPECT_GT(step.row(20)[kSize / 2 + 2], flat.row(20)[kSize / 2 + 2]);
}

TEST(FlipMetric, FewerPixelsADegreeBlurLess)
{
    const auto dot = [](int x, int y) { return Vec3d(x == 20 && y == 20 ? 1.0 : 0.0); };
    const Plane close = flipMap(picture(dot), uniform(Vec3d(0.0)), 20.0);
    const Plane far = flipMap(picture(dot), uniform(Vec3d(0.0)), 67.0);
    EXPECT_GT(close.row(20)[20], far.row(20)[20]);
}

}  // namespace
}  // namespace fbrdf

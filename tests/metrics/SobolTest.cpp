#include <fbrdf/metrics/Sobol.h>
#include <gtest/gtest.h>

#include <set>

namespace fbrdf {
namespace {

// Half a cell of 2^-32: what sobolPoint adds to the published numbers.
constexpr double kHalfCell = 0.5 / 4294967296.0;

TEST(Sobol, StartsAsPublished)
{
    // Joe and Kuo 2008, new-joe-kuo-6.21201, dimensions 1 to 4, in Gray-code-free order: point i
    // uses the bits of i.
    const double expected[8][4] = {
        {0, 0, 0, 0},
        {0.5, 0.5, 0.5, 0.5},
        {0.25, 0.75, 0.75, 0.75},
        {0.75, 0.25, 0.25, 0.25},
        {0.125, 0.625, 0.375, 0.125},
        {0.625, 0.125, 0.875, 0.625},
        {0.375, 0.375, 0.625, 0.875},
        {0.875, 0.875, 0.125, 0.375},
    };
    for (uint32_t i = 0; i < 8; ++i)
        for (size_t d = 0; d < 4; ++d)
            EXPECT_DOUBLE_EQ(sobolPoint(i, 0)[d], expected[i][d] + kHalfCell) << i << ", " << d;
}

// Number of different cells of a 2^a x 2^b grid that the first 2^(a+b) points fall into.
size_t cellsHit(uint32_t a, uint32_t b, uint64_t seed)
{
    std::set<std::pair<uint32_t, uint32_t>> cells;
    for (uint32_t i = 0; i < 1u << (a + b); ++i) {
        const auto p = sobolPoint(i, seed);
        cells.emplace(static_cast<uint32_t>(p[0] * (1u << a)),
                      static_cast<uint32_t>(p[1] * (1u << b)));
    }
    return cells.size();
}

TEST(Sobol, FirstTwoDimensionsAreAZeroMTwoNet)
{
    // One point in each elementary interval of volume 2^-m: the definition of a (0, m, 2)-net in
    // base 2.
    for (uint32_t m = 1; m <= 10; ++m)
        for (uint32_t a = 0; a <= m; ++a)
            EXPECT_EQ(cellsHit(a, m - a, 0), 1u << m) << m << ", " << a;
}

TEST(Sobol, ADigitalShiftKeepsTheNet)
{
    for (const uint64_t seed : {1ull, 42ull, 0xffffffffffffull})
        for (uint32_t a = 0; a <= 8; ++a) EXPECT_EQ(cellsHit(a, 8 - a, seed), 256u) << seed;
}

TEST(Sobol, EveryDimensionIsStratified)
{
    for (size_t d = 0; d < 4; ++d) {
        std::set<uint32_t> cells;
        for (uint32_t i = 0; i < 1024; ++i)
            cells.insert(static_cast<uint32_t>(sobolPoint(i, 7)[d] * 1024.0));
        EXPECT_EQ(cells.size(), 1024u) << d;
    }
}

TEST(Sobol, SeedsGiveDifferentPointsStrictlyInside)
{
    EXPECT_NE(sobolPoint(5, 1), sobolPoint(5, 2));
    for (const uint32_t i : {0u, 1u, 0x7fffffffu, 0xffffffffu})
        for (const double u : sobolPoint(i, 0)) {
            EXPECT_GT(u, 0.0);
            EXPECT_LT(u, 1.0);
        }
}

}  // namespace
}  // namespace fbrdf

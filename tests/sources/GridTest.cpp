// What readers share beneath their formats: rows that become samples, the MERL grid, streams.
#include "ReaderTest.h"

#include <fbrdf/brdf/HalfDifference.h>

#include <MerlGrid.h>
#include <SampleRow.h>

#include <limits>
#include <thread>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

constexpr double kTight = 1e-12;  // a few operations in double
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

SampleReport reportOfRow(const SampleRow& row, size_t expected)
{
    std::vector<Sample> samples;
    SampleReport report;
    addRow(row, samples, report);
    EXPECT_EQ(samples.size(), expected);
    EXPECT_EQ(report.given, 1u);
    return report;
}

}  // namespace

TEST(SampleRow, NormalisesWithoutOverflow)
{
    std::vector<Sample> samples;
    SampleReport report;
    addRow({{0, 0, 1e300}, {0, 3e-300, 4e-300}, Vec3d(1.0)}, samples, report);
    ASSERT_EQ(samples.size(), 1u);
    EXPECT_EQ(samples[0].wo, Vec3f(0, 0, 1));
    EXPECT_LT(glm::length(samples[0].wi - Vec3f(0, 0.6f, 0.8f)), 1e-6f);
}

TEST(SampleRow, CountsEachReasonOnce)
{
    const Vec3d up(0, 0, 1), down(0, 0, -1), one(1.0);
    EXPECT_EQ(reportOfRow({up, up, one}, 1).nonFinite, 0u);
    EXPECT_EQ(reportOfRow({up, {kNan, 0, 1}, one}, 0).nonFinite, 1u);
    EXPECT_EQ(reportOfRow({up, Vec3d(0.0), one}, 0).nonFinite, 1u);
    EXPECT_EQ(reportOfRow({up, up, {1, kNan, 1}}, 0).nonFinite, 1u);
    EXPECT_EQ(reportOfRow({up, up, {1, 1, -1e300}}, 0).nonFinite, 1u);
    EXPECT_EQ(reportOfRow({up, up, one, -1.0}, 0).nonFinite, 1u);
    EXPECT_EQ(reportOfRow({up, up, one, kNan}, 0).nonFinite, 1u);
    EXPECT_EQ(reportOfRow({down, up, one}, 0).belowHorizon, 1u);
    EXPECT_EQ(reportOfRow({up, {1, 0, 1e-9}, one}, 0).belowHorizon, 1u);
    EXPECT_EQ(reportOfRow({up, up, {1, -1, 0}}, 1).negative, 1u);
    EXPECT_EQ(reportOfRow({up, up, {1, -1, 0}}, 1).zero, 1u);
}

TEST(SampleReport, AddsUp)
{
    SampleReport a;
    a.given = 1, a.nonFinite = 2, a.belowHorizon = 3, a.invalid = 4;
    a.negative = 5, a.zero = 6, a.outOfGamut = 7;
    SampleReport b = a;
    b += a;
    EXPECT_EQ(b.given, 2u);
    EXPECT_EQ(b.nonFinite, 4u);
    EXPECT_EQ(b.belowHorizon, 6u);
    EXPECT_EQ(b.invalid, 8u);
    EXPECT_EQ(b.negative, 10u);
    EXPECT_EQ(b.zero, 12u);
    EXPECT_EQ(b.outOfGamut, 14u);
}

TEST(MerlGrid, CentresFallIntoTheirCells)
{
    for (const double span : {kPi, 2 * kPi}) {
        const MerlGrid grid({9, 10, 12}, span);
        ASSERT_EQ(grid.size(), 1080u);
        for (size_t cell = 0; cell < grid.size(); ++cell) {
            const DirectionPair<double> pair = grid.pair(cell);
            EXPECT_NEAR(glm::length(pair.wo), 1.0, kTight);
            EXPECT_NEAR(glm::length(pair.wi), 1.0, kTight);
            EXPECT_EQ(grid.cellOf(pair), cell);
        }
    }
}

TEST(MerlGrid, ThetaHIsSquareRootSpacedAndPhiHIsZero)
{
    const MerlGrid grid;
    const size_t cell = (30 * 90 + 20) * 180 + 50;
    const HalfDifference a = halfDifferenceFromPair(grid.pair(cell));
    EXPECT_NEAR(a.theta_h, 30.5 / 90 * 30.5 / 90 * kPi / 2, kTight);
    EXPECT_NEAR(a.phi_h, 0.0, kTight);
    EXPECT_NEAR(a.theta_d, 20.5 / 90 * kPi / 2, kTight);
    EXPECT_NEAR(a.phi_d, 50.5 / 180 * kPi, kTight);
}

TEST(MerlGrid, SwappingTheDirectionsKeepsTheCell)
{
    const MerlGrid half, full({90, 90, 360}, 2 * kPi);
    const DirectionPair<double> pair = half.pair((30 * 90 + 20) * 180 + 50);
    EXPECT_EQ(half.cellOf({pair.wi, pair.wo}), half.cellOf(pair));
    EXPECT_NE(full.cellOf({pair.wi, pair.wo}), full.cellOf(pair));
    EXPECT_NE(half.key(), full.key());
}

TEST(SampleStream, ThreadsReadTheSame)
{
    Source source;
    source.evaluate = [](const Vec3d& wo, const Vec3d& wi) { return Vec3d(wo.z, wi.z, wo.x); };
    source.stream = streamOnGrid(MerlGrid({20, 20, 20}), source.evaluate);
    const std::vector<Sample> whole = allSamples(source);
    std::vector<Sample> parts[2];
    SampleReport reports[2];
    {
        std::thread other([&] { source.stream.read(4000, 4000, parts[1], reports[1]); });
        source.stream.read(0, 4000, parts[0], reports[0]);
        other.join();
    }
    ASSERT_EQ(parts[0].size() + parts[1].size(), whole.size());
    for (size_t i = 0; i < whole.size(); ++i) {
        const bool first = i < parts[0].size();
        EXPECT_EQ((first ? parts[0][i] : parts[1][i - parts[0].size()]).f, whole[i].f);
    }
    EXPECT_EQ(reports[0].given + reports[1].given, 8000u);
    EXPECT_TRUE(hasSamples(source));
    EXPECT_FALSE(hasSamples(Source()));
}

// LobeSamplingTest.cpp - directions that are drawn against the density that is claimed for them: by
// counts in cells (chi-square), by integrals, and by the albedo that they estimate.
#include <fbrdf/brdf/LobeSampling.h>
#include <gtest/gtest.h>

#include "support/DirectionCells.h"

#include <cmath>
#include <random>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

LobeTable tableOf(LobeAxes axes, int lobes, float level, float weight)
{
    LobeTable table;
    table.axes = axes;
    table.lobes = lobes;
    table.thetas = 4;
    table.spread = 0.3f;
    for (int i = 0; i < 4; ++i) {
        LobeKnot knot;
        knot.cosine = {0.1f, 0.2f, 0.3f};
        for (size_t k = 0; k < static_cast<size_t>(lobes); ++k)
            knot.lobes[k] = {Vec3f(weight, weight, 0.5f * weight),
                             level + 0.6f * static_cast<float>(k),
                             axes == LobeAxes::tilted && i > 0 ? 0.4f : 0.0f};
        table.knots.push_back(knot);
    }
    return table;
}

std::vector<LobeTable> testTables()
{
    return {tableOf(LobeAxes::tilted, 1, 3.3f, 0.4f), tableOf(LobeAxes::tilted, 3, 2.0f, 0.1f),
            tableOf(LobeAxes::bent, 3, 3.5f, 0.2f), tableOf(LobeAxes::tilted, 1, 6.0f, 0.3f)};
}

const Vec3d kViews[] = {{0, 0, 1}, directionAt(0.7, 2.0), directionAt(1.4, -1.0)};

double excessOf(const LobeTable& sampled, const LobeTable& claimed, const Vec3d& wo)
{
    constexpr int kSamples = 200000;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(0.0, 1.0);
    std::vector<int> counts(static_cast<size_t>(kCellRows * kCellColumns), 0);
    for (int i = 0; i < kSamples; ++i) {
        const double x = number(random), y = number(random);
        ++counts[directionCell(sampleLobes(sampled, wo, Vec2<double>(x, y)).wi)];
    }
    const auto expected =
        cellProbabilities([&](const Vec3d& wi) { return lobePdf(claimed, wo, wi); });
    return chiSquareExcess(expected, counts, kSamples);
}

TEST(LobeSampling, DrawsWithTheDensityThatItClaims)
{
    // Four standard deviations, and what the sums over cells are off by.
    for (const LobeTable& table : testTables())
        for (const Vec3d& wo : kViews) EXPECT_LT(excessOf(table, table, wo), 5.0) << wo.z;
}

TEST(LobeSampling, AnotherDensityIsSeen)  // the tester itself
{
    const LobeTable a = tableOf(LobeAxes::tilted, 1, 3.3f, 0.4f),
                    b = tableOf(LobeAxes::tilted, 1, 3.45f, 0.4f);
    EXPECT_GT(excessOf(a, b, kViews[1]), 20.0);
}

TEST(LobeSampling, DensityOfASampleIsThatOfItsDirection)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> number(0.0, 1.0);
    for (const LobeTable& table : testTables())
        for (const Vec3d& wo : kViews)
            for (int i = 0; i < 200; ++i) {
                const double x = number(random), y = number(random);
                const auto sample = sampleLobes(table, wo, Vec2<double>(x, y));
                EXPECT_NEAR(glm::length(sample.wi), 1.0, 1e-12);
                EXPECT_GT(sample.pdf, 0.0);
                EXPECT_EQ(sample.pdf, lobePdf(table, wo, sample.wi));
            }
}

TEST(LobeSampling, DensityIntegratesToOne)
{
    for (const LobeTable& table : testTables())
        for (const Vec3d& wo : kViews) {
            double sum = 0.0;
            for (const double p :
                 cellProbabilities([&](const Vec3d& wi) { return lobePdf(table, wo, wi); }))
                sum += p;
            EXPECT_NEAR(sum, 1.0, 2e-3);
        }
}

TEST(LobeSampling, EstimatesTheAlbedoOfAMirroredCosine)
{
    // f cos = 0.3 times the stretched cosine about the normal: its albedo is 0.3.
    constexpr int kSamples = 40000;
    const LobeTable table = tableOf(LobeAxes::tilted, 1, 3.3f, 0.4f);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> number(0.0, 1.0);
    double sum = 0.0;
    for (int i = 0; i < kSamples; ++i) {
        const double x = number(random), y = number(random);
        const auto sample = sampleLobes(table, Vec3d(0, 0, 1), Vec2<double>(x, y));
        sum += 0.3 * stretchedCosine(sample.wi.z, 0.2) / sample.pdf;
    }
    EXPECT_NEAR(sum / kSamples, 0.3, 0.005);
}

TEST(LobeSampling, FloatsFollowDoubles)
{
    for (const LobeTable& table : testTables())
        for (const Vec3d& wo : kViews)
            for (double x = 0.01; x < 1.0; x += 0.083) {
                const auto exact = sampleLobes(table, wo, Vec2<double>(x, 0.37));
                const auto rough =
                    sampleLobes(table, Vec3f(wo), Vec2<float>(static_cast<float>(x), 0.37f));
                EXPECT_LT(glm::length(Vec3d(rough.wi) - exact.wi), 1e-4) << x;
                EXPECT_NEAR(double(rough.pdf), exact.pdf, 1e-3 * exact.pdf) << x;
            }
}

TEST(LobeSampling, BlackIsSampledByTheCosine)
{
    LobeTable table = tableOf(LobeAxes::tilted, 1, 3.0f, 0.0f);
    for (LobeKnot& knot : table.knots) knot.cosine = Vec3f(0.0f);
    EXPECT_NEAR(lobePdf(table, kViews[1], directionAt(0.5, 1.0)), std::cos(0.5) / kPi, 1e-12);
}

}  // namespace

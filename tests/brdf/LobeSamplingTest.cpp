// LobeSamplingTest.cpp - directions that are drawn against the density that is claimed for them: by
// counts in cells (chi-square), by integrals, and by the albedo that they estimate.
#include <fbrdf/brdf/LobeSampling.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace fbrdf;

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

Vec3d direction(double theta, double phi)
{
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

const Vec3d kViews[] = {{0, 0, 1}, direction(0.7, 2.0), direction(1.4, -1.0)};

/// Cells over the whole sphere, even in theta and phi.
constexpr int kRows = 24, kColumns = 48;
size_t cellOf(const Vec3d& w)
{
    const int row = std::clamp(
        static_cast<int>(std::acos(std::clamp(w.z, -1.0, 1.0)) / kPi * kRows), 0, kRows - 1);
    const double turn = std::atan2(w.y, w.x) / (2.0 * kPi) + 0.5;
    const int column = std::clamp(static_cast<int>(turn * kColumns), 0, kColumns - 1);
    return static_cast<size_t>(row * kColumns + column);
}

/// The probability of each cell by a fine sum.
template <class Density>
std::vector<double> probabilities(const Density& density)
{
    constexpr int kFine = 20;
    std::vector<double> result(static_cast<size_t>(kRows * kColumns), 0.0);
    for (int i = 0; i < kRows * kFine; ++i)
        for (int j = 0; j < kColumns * kFine; ++j) {
            const double theta = kPi * (i + 0.5) / (kRows * kFine);
            const double phi = 2.0 * kPi * ((j + 0.5) / (kColumns * kFine) - 0.5);
            const Vec3d w = direction(theta, phi);
            result[cellOf(w)] +=
                density(w) * std::sin(theta) * 2.0 * kPi * kPi / (kRows * kFine * kColumns * kFine);
        }
    return result;
}

/// Standard deviations by which chi-square exceeds its mean, over cells with enough samples.
double chiSquareExcess(const std::vector<double>& expected, const std::vector<int>& counts,
                       int samples)
{
    double sum = 0.0, cells = 0.0;
    for (size_t i = 0; i < counts.size(); ++i) {
        const double mean = expected[i] * samples;
        if (mean < 5.0) continue;
        sum += (counts[i] - mean) * (counts[i] - mean) / mean;
        cells += 1.0;
    }
    return (sum - cells) / std::sqrt(2.0 * cells);
}

double excessOf(const LobeTable& sampled, const LobeTable& claimed, const Vec3d& wo)
{
    constexpr int kSamples = 200000;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(0.0, 1.0);
    std::vector<int> counts(static_cast<size_t>(kRows * kColumns), 0);
    for (int i = 0; i < kSamples; ++i) {
        const double x = number(random), y = number(random);
        ++counts[cellOf(sampleLobes(sampled, wo, Vec2<double>(x, y)).wi)];
    }
    const auto expected = probabilities([&](const Vec3d& wi) { return lobePdf(claimed, wo, wi); });
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
                 probabilities([&](const Vec3d& wi) { return lobePdf(table, wo, wi); }))
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
    EXPECT_NEAR(lobePdf(table, kViews[1], direction(0.5, 1.0)), std::cos(0.5) / kPi, 1e-12);
}

}  // namespace

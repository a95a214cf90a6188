#include "ReaderTest.h"

#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/sources/OpenSource.h>

#include <limits>

using namespace fbrdf;
using namespace fbrdf::test;

namespace {

constexpr int kH = 5, kD = 6, kP = 8;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Value of the synthetic table in a cell and channel, in 1/sr.
double valueOf(size_t cell, int channel)
{
    return 0.01 * double(cell + 1) + channel;
}

std::string table(int h = kH, int d = kD, int p = kP)
{
    std::string bytes;
    for (const int count : {h, d, p}) append(bytes, int32_t(count));
    const double scale[3] = {1500.0, 1500.0 / 1.15, 1500.0 / 1.66};
    for (int c = 0; c < 3; ++c)
        for (size_t cell = 0; cell < size_t(h * d * p); ++cell)
            append(bytes, valueOf(cell, c) * scale[c]);
    return bytes;
}

void setCell(std::string& bytes, size_t cell, int channel, double value)
{
    const size_t cells = size_t(kH * kD * kP);
    std::memcpy(&bytes[12 + (size_t(channel) * cells + cell) * 8], &value, 8);
}

size_t cellIndex(int h, int d, int p)
{
    return size_t((h * kD + d) * kP + p);
}

DirectionPair<double> centre(int h, int d, int p, double span = kPi)
{
    const double root = (h + 0.5) / kH;
    return pairFromHalfDifference(
        {root * root * kPi / 2, 0.3, (d + 0.5) / kD * kPi / 2, (p + 0.5) / kP * span});
}

Source read(const std::string& bytes)
{
    const TempFolder folder;
    return openSource(folder.write("gold.binary", bytes));
}

}  // namespace

TEST(Merl, EvaluatesTheCellOfAPairScaled)
{
    const Source source = read(table());
    EXPECT_EQ(source.format, "merl");
    EXPECT_EQ(source.name, "gold");
    EXPECT_TRUE(source.isotropic);
    size_t above = 0;
    for (int h = 0; h < kH; ++h)
        for (int d = 0; d < kD; ++d)
            for (int p = 0; p < kP; ++p) {
                const DirectionPair<double> pair = centre(h, d, p);
                if (pair.wo.z <= 0.0 || pair.wi.z <= 0.0) continue;
                ++above;
                const Vec3d f = source.evaluate(pair.wo, pair.wi);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(f[c], valueOf(cellIndex(h, d, p), c), 1e-6 * f[c]);
                // phi_d and phi_d + pi are one cell: the table takes reciprocity for granted.
                EXPECT_EQ(source.evaluate(pair.wi, pair.wo), f);
            }
    EXPECT_GT(above, 100u);
}

TEST(Merl, StreamsTheCentresOfTheCells)
{
    const Source source = read(table());
    expectSound(source);
    EXPECT_TRUE(source.samples.empty());
    EXPECT_EQ(source.stream.rows, size_t(kH * kD * kP));
    EXPECT_EQ(source.stream.geometry, "merl 5x6x8");
    const SampleReport report = reportOf(source);
    EXPECT_EQ(report.given, source.stream.rows);
    EXPECT_EQ(report.invalid, 0u);
    for (const Sample& s : allSamples(source)) {
        const Vec3d f = source.evaluate(Vec3d(s.wo), Vec3d(s.wi));
        EXPECT_LT(glm::length(f - Vec3d(s.f)), 1e-6);
    }
}

TEST(Merl, AnyNegativeChannelMarksACell)
{
    std::string bytes = table();
    setCell(bytes, cellIndex(1, 2, 3), 0, -1.0);
    setCell(bytes, cellIndex(1, 2, 4), 2, -1e-9);
    setCell(bytes, cellIndex(0, 0, 0), 1, kNan);
    const Source source = read(bytes);
    const SampleReport report = reportOf(source);
    EXPECT_EQ(report.invalid, 2u);
    EXPECT_EQ(report.nonFinite, 1u);
    EXPECT_EQ(report.negative, 0u);
    expectSound(source);
}

TEST(Merl, CellsThatAreNotValidTakeTheirNeighbourInThetaD)
{
    std::string bytes = table();
    setCell(bytes, cellIndex(1, 2, 3), 0, -1.0);
    setCell(bytes, cellIndex(1, 3, 3), 0, -1.0);
    const Source source = read(bytes);
    const DirectionPair<double> pair = centre(1, 3, 3);
    EXPECT_NEAR(source.evaluate(pair.wo, pair.wi).y, valueOf(cellIndex(1, 1, 3), 1), 1e-5);
}

TEST(Merl, TablesOf360CoverTheFullCircle)
{
    const Source source = read(table(2, 2, 360));
    EXPECT_EQ(source.stream.geometry, "merl 2x2x360 full");
    const DirectionPair<double> pair = pairFromHalfDifference({0.1, 0.0, 0.2, 0.5});
    EXPECT_NE(source.evaluate(pair.wo, pair.wi), source.evaluate(pair.wi, pair.wo));
}

TEST(Merl, NothingValidIsAnError)
{
    std::string bytes = table();
    for (size_t cell = 0; cell < size_t(kH * kD * kP); ++cell) setCell(bytes, cell, 1, -1.0);
    const TempFolder folder;
    expectInputError(folder.write("gold.binary", bytes), "no valid cell");
}

TEST(Merl, RefusesWrongSizes)
{
    const TempFolder folder;
    const auto refuse = [&](std::array<int32_t, 3> counts, const std::string& part) {
        std::string bytes = table();
        std::memcpy(bytes.data(), counts.data(), 12);
        expectInputError(folder.write("gold.binary", bytes), part);
    };
    refuse({90, 90, 180}, "expected 34992012 for a table of 90 x 90 x 180");
    refuse({0, 6, 8}, "at byte 0");
    refuse({-5, 6, 8}, "at byte 0");
    refuse({2147483647, 2147483647, 2147483647}, "at byte 0");
    refuse({65536, 65536, 65536}, "expected");
    expectInputError(folder.write("gold.binary", table() + "x"), "expected");
    expectInputError(folder.write("gold.binary", table().substr(0, 7)), "at byte 0");
}

TEST(Merl, NoPrefixIsRead)
{
    const std::string bytes = table(2, 3, 4);
    EXPECT_EQ(refusedPrefixes("gold.binary", bytes), bytes.size());
    expectSurvivesDamage("gold.binary", bytes, 7);  // each opening costs a stream
}

#include "data/Dataset.h"

#include "Known.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace fbrdf {
namespace {

Source numbered(size_t count)
{
    Source source;
    for (size_t i = 0; i < count; ++i)
        source.samples.push_back({Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(float(i)), 1.0f});
    return source;
}

TEST(Dataset, BlocksHoldEverySampleOnceInOrder)
{
    const Source source = numbered(2 * kBlockRows + 77);
    const Dataset dataset = makeDataset(source, 0, 1, 1);
    ASSERT_EQ(dataset.blocks(), 3u);
    EXPECT_FALSE(dataset.exact);
    DatasetScratch scratch;
    float next = 0.0f;
    for (size_t b = 0; b < dataset.blocks(); ++b) {
        const DatasetBlock block = dataset.block(b, scratch);
        for (size_t i = 0; i < block.count; ++i) EXPECT_EQ(block.samples[i].f.x, next++);
    }
    EXPECT_EQ(next, float(source.samples.size()));
}

// Values near the horizon were divided by a cosine near 0; a function beside them says the same
// without that noise.
TEST(Dataset, NodesOfATableCountLessNearTheHorizon)
{
    Source source;
    const double degrees[] = {1.0, 6.0, 20.0, 90.0};  // elevations
    for (const double d : degrees) {
        const double angle = d * kPi / 180.0;
        const Vec3f low(Vec3d(std::cos(angle), 0.0, std::sin(angle))), up(0, 0, 1);
        source.samples.push_back({low, up, Vec3f(1.0f), 1.0f});
        source.samples.push_back({up, low, Vec3f(1.0f), 0.5f});
    }
    const auto weightsOf = [](const Dataset& dataset) {
        std::vector<float> weights;
        DatasetScratch scratch;
        const DatasetBlock block = dataset.block(0, scratch);
        for (size_t i = 0; i < 8; ++i) weights.push_back(block.samples[i].weight);
        return weights;
    };
    const std::vector<float> alone = weightsOf(makeDataset(source, 100, 1, 1));
    EXPECT_EQ(alone, (std::vector<float>{1, 0.5f, 1, 0.5f, 1, 0.5f, 1, 0.5f}));
    source.evaluate = [](const Vec3d&, const Vec3d&) { return Vec3d(1.0); };
    const Dataset both = makeDataset(source, 100, 1, 1);
    EXPECT_EQ(both.rows, 108u);
    const std::vector<float> weights = weightsOf(both);
    const double expected[] = {0.001, 0.544, 0.993, 1.0};  // c^4 / (c^4 + 0.1^4)
    for (size_t i = 0; i < 8; ++i)
        EXPECT_NEAR(weights[i], static_cast<double>(alone[i]) * expected[i / 2], 0.001) << i;
}

TEST(Dataset, AStreamGivesTheSamplesOfTheListItCameFrom)
{
    const Source held = numbered(20000);
    Source streamed;
    streamed.stream.rows = held.samples.size();
    streamed.stream.read = [&](uint64_t first, size_t count, std::vector<Sample>& out,
                               SampleReport&) {
        for (uint64_t i = first; i < first + count; ++i) out.push_back(held.samples[i]);
    };
    const Dataset a = makeDataset(held, 0, 1, 1), b = makeDataset(streamed, 0, 1, 2);
    DatasetScratch scratch, other;
    ASSERT_EQ(a.blocks(), b.blocks());
    for (size_t k = 0; k < a.blocks(); ++k) {
        const DatasetBlock p = a.block(k, scratch), q = b.block(k, other);
        ASSERT_EQ(p.count, q.count);
        for (size_t i = 0; i < p.count; ++i) ASSERT_EQ(p.samples[i].f.x, q.samples[i].f.x);
    }
}

TEST(Dataset, GeometryIsThatOfDirectionsAndWeightsAlone)
{
    Source source = test::scattered(test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.0}), 9000, 1);
    const auto geometry = [&source] { return geometryOf(makeDataset(source, 0, 1, 2), 2); };
    const std::string before = geometry();
    for (Sample& s : source.samples) s.f *= 2.0f;
    EXPECT_EQ(geometry(), before);
    source.samples[8500].weight = 0.5f;
    const std::string weighted = geometry();
    EXPECT_NE(weighted, before);
    std::swap(source.samples[10], source.samples[11]);
    EXPECT_NE(geometry(), weighted);
}

TEST(Dataset, AFunctionIsExact)
{
    EXPECT_TRUE(makeDataset(test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.0}), 100, 1, 1).exact);
}

TEST(Folds, AreOfEqualSizeAndDependOnTheSeed)
{
    constexpr int kCount = 50000;
    std::array<int, kFolds> sizes{};
    int same = 0;
    for (uint64_t i = 0; i < kCount; ++i) {
        ++sizes[size_t(foldOf(i, 1))];
        same += foldOf(i, 1) == foldOf(i, 2) ? 1 : 0;
    }
    // Binomial: 10,000 +- 89; five sigma, five folds and one agreement.
    for (const int size : sizes) EXPECT_NEAR(size, kCount / kFolds, 5 * 89);
    EXPECT_NEAR(same, kCount / kFolds, 5 * 89);
}

TEST(Folds, SomeSamplesOfAFoldAreThoseOfThatFold)
{
    const Source source = numbered(3000);
    const Dataset dataset = makeDataset(source, 0, 1, 1);
    size_t all = 0;
    for (int fold = 0; fold < kFolds; ++fold) {
        const auto part = someSamples(dataset, FoldChoice::onlyOf(fold), 10000, 9);
        for (const Sample& s : part) EXPECT_EQ(foldOf(uint64_t(s.f.x), 9), fold);
        all += part.size();
    }
    EXPECT_EQ(all, source.samples.size());
    EXPECT_LE(someSamples(dataset, FoldChoice::all(), 100, 9).size(), 100u);
}

TEST(Folds, AllButOneAreTheOthers)
{
    const Source source = numbered(3000);
    const Dataset dataset = makeDataset(source, 0, 1, 1);
    const auto others = someSamples(dataset, FoldChoice::allBut(2), 10000, 9),
               fold = someSamples(dataset, FoldChoice::onlyOf(2), 10000, 9);
    for (const Sample& s : others) EXPECT_NE(foldOf(uint64_t(s.f.x), 9), 2);
    EXPECT_EQ(others.size() + fold.size(), source.samples.size());
}

// A stream that drops a seventh of its rows; red is the number of the row, so rows < 2^24.
SampleStream dropping(uint64_t rows)
{
    SampleStream stream;
    stream.rows = rows;
    stream.read = [](uint64_t first, size_t count, std::vector<Sample>& out, SampleReport&) {
        for (uint64_t i = first; i < first + count; ++i)
            if (splitMix64(i) % 7 != 0)
                out.push_back({Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(float(i)), 1.0f});
    };
    return stream;
}

// The number under which fits meet a row: they read blocks.
uint64_t numberInItsBlock(const Dataset& dataset, uint64_t row)
{
    DatasetScratch scratch;
    const DatasetBlock block = dataset.block(size_t(row / kBlockRows), scratch);
    for (size_t i = 0; i < block.count; ++i)
        if (uint64_t(block.samples[i].f.x) == row) return block.number(i);
    throw std::runtime_error("the row was dropped");
}

TEST(Folds, ALongStreamThatDropsRowsHasTheFoldsThatFitsSee)
{
    const SampleStream stream = dropping(60000);
    const Dataset dataset = datasetOfStream(stream);
    for (const int fold : {0, 3}) {
        const auto part = someSamples(dataset, FoldChoice::onlyOf(fold), 500, 9);
        EXPECT_GT(part.size(), 300u);
        for (const Sample& s : part)
            EXPECT_EQ(foldOf(numberInItsBlock(dataset, uint64_t(s.f.x)), 9), fold);
    }
}

TEST(Dataset, NumbersOfAStreamThatDropsRowsAreUniqueAndRise)
{
    const SampleStream stream = dropping(20000);
    const Dataset dataset = datasetOfStream(stream);
    DatasetScratch scratch;
    uint64_t next = 0, samples = 0;
    for (size_t b = 0; b < dataset.blocks(); ++b) {
        const DatasetBlock block = dataset.block(b, scratch);
        for (size_t i = 0; i < block.count; ++i) {
            EXPECT_GE(block.number(i), next);
            next = block.number(i) + 1;
        }
        samples += block.count;
    }
    EXPECT_LT(samples, 20000u * 7 / 8);  // some were dropped
    EXPECT_LE(next, 20000u);
}

TEST(Folds, SomeSamplesAreTheSameOnAnyNumberOfThreads)
{
    const Source source = numbered(50000);
    const Dataset dataset = makeDataset(source, 0, 1, 1);
    const auto one = someSamples(dataset, FoldChoice::all(), 5000, 9, 1),
               four = someSamples(dataset, FoldChoice::all(), 5000, 9, 4);
    ASSERT_EQ(one.size(), four.size());
    for (size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].f.x, four[i].f.x);
}

TEST(Folds, SomeSamplesAreSpreadOverAllOfThem)
{
    // Half of the samples: a stride of whole numbers would take the first half.
    const Source source = numbered(20000);
    const auto part = someSamples(makeDataset(source, 0, 1, 1), FoldChoice::all(), 10000, 9);
    EXPECT_LE(part.size(), 10000u);
    EXPECT_GT(part.size(), 9000u);
    double sum = 0.0;
    for (const Sample& s : part) sum += double(s.f.x);
    // The mean of 10,000 of 0 .. 19,999 has a standard deviation of 58.
    EXPECT_NEAR(sum / double(part.size()), 9999.5, 5 * 58.0);
}

TEST(Dataset, ALongStreamIsLookedIntoHereAndThere)
{
    uint64_t rowsRead = 0;
    Source source;
    source.stream.rows = uint64_t{1} << 36;
    source.stream.read = [&](uint64_t first, size_t count, std::vector<Sample>& out,
                             SampleReport&) {
        rowsRead += count;
        for (uint64_t i = first; i < first + count; ++i)
            out.push_back({Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(float(i)), 1.0f});
    };
    const auto part = someSamples(makeDataset(source, 0, 1, 1), FoldChoice::all(), 5000, 9);
    EXPECT_GT(part.size(), 4000u);
    EXPECT_LE(rowsRead, 20000u);
    EXPECT_GT(part.back().f.x, 0.9f * std::ldexp(1.0f, 36));
}

TEST(Dataset, AFunctionFillsTheHolesOfATableOfFewNodes)
{
    Source table = test::scattered(test::sourceOf(test::Ggx{0.3, 0.3, 0.1, 0.2}), 100, 1);
    EXPECT_EQ(makeDataset(table, 1000, 1, 1).rows, 100u);
    table.evaluate = test::Ggx{0.3, 0.3, 0.1, 0.2};
    const Dataset filled = makeDataset(table, 1000, 1, 1);
    EXPECT_EQ(filled.rows, 1100u);
    EXPECT_FALSE(filled.exact);
    EXPECT_EQ(makeDataset(table, 100, 1, 1).rows, 100u);  // as many as are wanted: as they are
}

}  // namespace
}  // namespace fbrdf

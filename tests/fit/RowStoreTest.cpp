#include "solve/LeastSquares.h"

#include "Known.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fbrdf {
namespace {

constexpr HdioSizes kSizes{16, 6, 6};

struct Rows {
    Dataset dataset;
    DataStatistics statistics;
    Form form = formHdio(kSizes);
    Layout layout{form};
    RowMaker maker{form, layout};

    explicit Rows(std::vector<Sample> samples)
        : dataset(datasetInMemory(std::move(samples))),
          statistics(statisticsOf(someSamples(dataset, FoldChoice::all(), 20000, 1), false, "data"))
    {
    }
    RowStore store() const { return RowStore(maker, dataset, statistics, 2, nullptr); }
    int firstUnknown(const RowGeometry& rows, size_t i) const
    {
        return rows.unknown[i * size_t(maker.width()) + size_t(maker.bandedFirst())];
    }
};

std::vector<Sample> samplesOfGgx(size_t count)
{
    return samplesAt(test::sourceOf(test::Ggx{0.3, 0.3, 0.5, 0.1}), uniformPairs(count, 3), 2);
}

TEST(RowStore, ScatteredRowsStandByTexelAndKeepTheirNumbers)
{
    const Rows rows(samplesOfGgx(kBlockRows + 500));
    const RowStore store = rows.store();
    const auto width = size_t(rows.maker.width());
    RowStore::Scratch scratch;
    DatasetScratch datasetScratch;
    for (size_t b = 0; b < store.blocks(); ++b) {
        const RowStore::Block block = store.block(b, scratch);
        const DatasetBlock samples = rows.dataset.block(b, datasetScratch);
        ASSERT_EQ(block.geometry.count, samples.count);
        std::vector<bool> isMet(samples.count);
        std::vector<int> unknown(width);
        std::vector<float> weight(width);
        for (size_t i = 0; i < samples.count; ++i) {
            if (i > 0) {
                EXPECT_LE(rows.firstUnknown(block.geometry, i - 1),
                          rows.firstUnknown(block.geometry, i));
            }
            const size_t at = block.geometry.number(i) - samples.first;
            ASSERT_LT(at, samples.count);
            EXPECT_FALSE(isMet[at]);
            isMet[at] = true;
            rows.maker.make(samples.samples[at], unknown.data(), weight.data());
            EXPECT_TRUE(
                std::equal(unknown.begin(), unknown.end(), &block.geometry.unknown[i * width]));
            EXPECT_TRUE(
                std::equal(weight.begin(), weight.end(), &block.geometry.weight[i * width]));
            EXPECT_EQ(block.geometry.cosine[i], samples.samples[at].wi.z);
            EXPECT_FLOAT_EQ(block.values.logValue[i].y, std::log2(samples.samples[at].f.y));
        }
    }
}

TEST(RowStore, RowsThatAreInOrderStayWhereTheyAre)
{
    std::vector<Sample> samples = samplesOfGgx(3000);
    std::sort(samples.begin(), samples.end(),
              [](const Sample& a, const Sample& b) { return a.wo.z + a.wi.z > b.wo.z + b.wi.z; });
    const Rows rows(samples);
    const RowStore store = rows.store();
    RowStore::Scratch scratch;
    EXPECT_TRUE(store.block(0, scratch).geometry.offsets.empty());
}

// Values of data on the same grid are put into the order that the grid's rows have been given.
TEST(RowStore, SharedRowsGetTheValuesOfTheirSamples)
{
    std::vector<Sample> samples = samplesOfGgx(2000);
    const Rows first(samples);
    const RowStore store = first.store();
    for (size_t i = 0; i < samples.size(); ++i) samples[i].f = Vec3f(1.0f + float(i));
    const Rows second(samples);
    const RowStore shared(second.maker, second.dataset, second.statistics, 2, store.geometry());
    RowStore::Scratch scratch;
    const RowStore::Block block = shared.block(0, scratch);
    for (size_t i = 0; i < samples.size(); ++i)
        EXPECT_FLOAT_EQ(block.values.logValue[i].x,
                        std::log2(1.0f + float(block.geometry.number(i))));
}

}  // namespace
}  // namespace fbrdf

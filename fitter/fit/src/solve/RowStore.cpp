#include "solve/RowStore.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Parallel.h>
#include "solve/RowKernel.h"

#include <algorithm>

namespace fbrdf {
namespace {

constexpr size_t kKeptBytes = size_t{384} << 20;  // of rows; more are made again in every pass

size_t bytesPerRow(int width, bool unclipped)
{
    const size_t values = unclipped ? sizeof(Vec3f) + sizeof(float) : 0;
    return static_cast<size_t>(width) * (sizeof(int) + sizeof(float)) + sizeof(float) +
           2 * sizeof(Vec3f) + 1 + values;
}

}  // namespace

RowStore::RowStore(const RowMaker& maker, const Dataset& dataset, const DataStatistics& statistics,
                   int threads, std::shared_ptr<const RowGeometries> known)
    : maker_(maker),
      dataset_(dataset),
      statistics_(statistics),
      geometry_(std::move(known)),
      sameWeights_(statistics.sameWeights)
{
    if (!dataset.inMemory ||
        dataset.rows * bytesPerRow(maker.width(), statistics.unclipped) > kKeptBytes)
        return;
    values_.resize(blocks());
    const auto made = geometry_ ? nullptr : std::make_shared<RowGeometries>(blocks());
    std::vector<char> same(blocks());
    parallelTasks(blocks(), threads, [&](size_t b) {
        DatasetScratch scratch;
        const DatasetBlock block = dataset_.block(b, scratch);
        if (made) makeGeometry(block, (*made)[b]);
        same[b] = makeValues(block, values_[b]) ? 1 : 0;
    });
    sameWeights_ = std::count(same.begin(), same.end(), 0) == 0;
    if (made) geometry_ = made;
}

void RowStore::makeGeometry(const DatasetBlock& block, RowGeometry& geometry) const
{
    const auto width = static_cast<size_t>(maker_.width());
    geometry.first = block.first;
    geometry.offsets.clear();
    if (block.offsets) geometry.offsets.assign(block.offsets, block.offsets + block.count);
    geometry.count = block.count;
    geometry.unknown.resize(block.count * width);
    geometry.weight.resize(block.count * width);
    geometry.cosine.resize(block.count);
    for (size_t i = 0; i < block.count; ++i) {
        maker_.make(block.samples[i], &geometry.unknown[i * width], &geometry.weight[i * width]);
        geometry.cosine[i] = block.samples[i].wi.z;
    }
}

bool RowStore::makeValues(const DatasetBlock& block, RowValues& values) const
{
    values.logValue.resize(block.count);
    values.weight.resize(block.count);
    values.censored.assign(block.count, 0);
    values.value.clear();
    values.sampleWeight.clear();
    bool same = true;
    for (size_t i = 0; i < block.count; ++i) {
        const Sample& sample = block.samples[i];
        if (statistics_.unclipped) {
            values.value.push_back(sample.f);
            values.sampleWeight.push_back(sample.weight);
        }
        for (int c = 0; c < 3; ++c) {
            const Observed o = observe(sample.f[c], sample.wi.z, statistics_, c, sample.weight);
            values.logValue[i][c] = o.value;
            values.weight[i][c] = o.weight;
            same = same && o.weight == sample.weight;
            if (o.censored) values.censored[i] |= static_cast<unsigned char>(1 << c);
        }
    }
    if (block.count > 0)
        rowKernels().log2(&values.logValue[0].x, 3 * static_cast<std::ptrdiff_t>(block.count));
    return same;
}

RowStore::Block RowStore::block(size_t index, Scratch& scratch) const
{
    FBRDF_ASSERT(index, <, blocks());
    if (!values_.empty()) return {(*geometry_)[index], values_[index]};
    const DatasetBlock block = dataset_.block(index, scratch.dataset);
    makeGeometry(block, scratch.geometry);
    makeValues(block, scratch.values);
    return {scratch.geometry, scratch.values};
}

}  // namespace fbrdf

#include "solve/RowStore.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Parallel.h>
#include "solve/RowKernel.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace fbrdf {
namespace {

constexpr size_t kKeptBytes = size_t{384} << 20;  // of rows; more are made again in every pass

size_t bytesPerRow(int width, bool unclipped)
{
    const size_t values = unclipped ? sizeof(Vec3f) + sizeof(float) : 0;
    return static_cast<size_t>(width) * (sizeof(int) + sizeof(float)) + sizeof(float) +
           2 * sizeof(Vec3f) + 1 + values;
}

// True when rows often jump from one place of the banded table to another, as scattered samples do
// and scans do not.
bool isScattered(const std::vector<int>& firstUnknown, int bandwidth)
{
    size_t jumps = 0;
    for (size_t i = 1; i < firstUnknown.size(); ++i)
        if (std::abs(firstUnknown[i] - firstUnknown[i - 1]) > bandwidth) ++jumps;
    return 2 * jumps > firstUnknown.size();
}

template <class T>
std::vector<T> reordered(const std::vector<T>& values, const std::vector<uint16_t>& order)
{
    const size_t width = values.size() / order.size();
    std::vector<T> result(values.size());
    for (size_t i = 0; i < order.size(); ++i)
        std::copy_n(&values[order[i] * width], width, &result[i * width]);
    return result;
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
        if (made) sortByTexel((*made)[b]);
        const RowGeometry& geometry = made ? (*made)[b] : (*geometry_)[b];
        same[b] = makeValues(block, geometry, values_[b]) ? 1 : 0;
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

// The sums of rows that look up the same texels stand in the same lines of the processor's cache.
void RowStore::sortByTexel(RowGeometry& geometry) const
{
    if (maker_.bandedLast() == 0 || !geometry.offsets.empty()) return;
    const auto width = static_cast<size_t>(maker_.width());
    std::vector<int> key(geometry.count);
    for (size_t i = 0; i < geometry.count; ++i)
        key[i] = geometry.unknown[i * width + static_cast<size_t>(maker_.bandedFirst())];
    if (!isScattered(key, maker_.bandwidth())) return;
    std::vector<uint16_t> order(geometry.count);
    std::iota(order.begin(), order.end(), uint16_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&key](uint16_t a, uint16_t b) { return key[a] < key[b]; });
    geometry.unknown = reordered(geometry.unknown, order);
    geometry.weight = reordered(geometry.weight, order);
    geometry.cosine = reordered(geometry.cosine, order);
    geometry.offsets = std::move(order);
}

bool RowStore::makeValues(const DatasetBlock& block, const RowGeometry& geometry,
                          RowValues& values) const
{
    const bool isSorted = !block.offsets && !geometry.offsets.empty();
    values.logValue.resize(block.count);
    values.weight.resize(block.count);
    values.censored.assign(block.count, 0);
    values.value.clear();
    values.sampleWeight.clear();
    bool same = true;
    for (size_t i = 0; i < block.count; ++i) {
        const Sample& sample = block.samples[isSorted ? geometry.offsets[i] : i];
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
    makeValues(block, scratch.geometry, scratch.values);
    return {scratch.geometry, scratch.values};
}

}  // namespace fbrdf

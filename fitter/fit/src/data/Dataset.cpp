#include "data/Dataset.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Parallel.h>
#include <fbrdf/metrics/SampleSets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>

namespace fbrdf {
namespace {

// A stream of at most this many rows (a MERL file, twice) is read once and held; 40 bytes a row.
constexpr size_t kHeldRows = 3000000;

using Owner = std::shared_ptr<const std::vector<Sample>>;

Dataset datasetOf(Owner owner, const std::vector<Sample>& samples)
{
    Dataset dataset;
    dataset.rows = samples.size();
    dataset.inMemory = true;
    dataset.read = [owner = std::move(owner), &samples](uint64_t first, size_t count,
                                                        DatasetScratch&) {
        FBRDF_ASSERT(first + count, <=, samples.size());
        return DatasetBlock{samples.data() + first, count, first};
    };
    return dataset;
}

// A stream does not report which rows it dropped. Read by pieces that always begin at the same
// rows, a sample is numbered by its piece and its place among the usable samples of that piece.
DatasetBlock readPieces(const SampleStream& stream, uint64_t first, size_t count,
                        DatasetScratch& scratch)
{
    FBRDF_ASSERT(first % kPieceRows, ==, 0u);
    FBRDF_ASSERT(count, <=, kBlockRows);
    SampleReport report;
    scratch.samples.clear();
    scratch.offsets.clear();
    for (size_t piece = 0; piece < count; piece += kPieceRows) {
        stream.read(first + piece, std::min(kPieceRows, count - piece), scratch.samples, report);
        for (size_t offset = piece; scratch.offsets.size() < scratch.samples.size(); ++offset)
            scratch.offsets.push_back(static_cast<uint16_t>(offset));
    }
    return {scratch.samples.data(), scratch.samples.size(), first, scratch.offsets.data()};
}

// The parts in order, cut off at the limit.
std::vector<Sample> joined(const std::vector<std::vector<Sample>>& parts, size_t limit)
{
    size_t size = 0;
    for (const auto& part : parts) size += part.size();
    std::vector<Sample> all;
    all.reserve(size);
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    all.resize(std::min(size, limit));
    return all;
}

Owner allSamples(const Dataset& dataset, int threads)
{
    std::vector<std::vector<Sample>> blocks(dataset.blocks());
    parallelTasks(blocks.size(), threads, [&](size_t b) {
        DatasetScratch scratch;
        dataset.block(b, scratch);
        blocks[b] = std::move(scratch.samples);
    });
    return std::make_shared<std::vector<Sample>>(joined(blocks, dataset.rows));
}

// Ranges of a dataset, in order: all of it, or pieces at equal distances, each a few points of a
// scan.
struct Ranges {
    uint64_t distance;
    size_t length, count;
};

Ranges rangesFor(const Dataset& dataset, uint64_t wanted)
{
    constexpr uint64_t kSparse = 4;
    const uint64_t pieces = (2 * wanted + kPieceRows - 1) / kPieceRows;
    if (dataset.inMemory || dataset.rows < kSparse * pieces * kPieceRows)
        return {kBlockRows, kBlockRows, dataset.blocks()};
    const uint64_t distance = dataset.rows / pieces / kPieceRows * kPieceRows;
    return {distance, kPieceRows, static_cast<size_t>(pieces)};
}

// Rows to look at for `limit` of the choice.
uint64_t wantedRows(const FoldChoice& choice, size_t limit)
{
    return static_cast<uint64_t>(std::ceil(static_cast<double>(limit) / choice.share()));
}

Dataset datasetOfSamples(const Source& source, int threads)
{
    if (!source.samples.empty()) return datasetOf(nullptr, source.samples);
    const Dataset stream = datasetOfStream(source.stream);
    if (stream.rows > kHeldRows) return stream;
    const Owner all = allSamples(stream, threads);
    return datasetOf(all, *all);
}

// What a sample counts by its elevations. Values near the horizon were divided by a cosine near 0,
// noise and all, and are seen in a few pixels if at all.
float weightOfElevation(const Sample& sample)
{
    constexpr double kLow = 0.1;  // 6 degrees count half
    const auto share = [](double cosine) {
        const double power = std::pow(cosine / kLow, 4.0);
        return power / (power + 1.0);
    };
    return static_cast<float>(share(static_cast<double>(sample.wo.z)) *
                              share(static_cast<double>(sample.wi.z)));
}

// A table of few nodes leaves holes that its own interpolation fills.
Dataset withFunction(const Dataset& nodes, const Source& source, size_t count, uint64_t seed,
                     int threads)
{
    std::vector<Sample> all = someSamples(nodes, FoldChoice::all(), nodes.rows, seed, threads);
    for (Sample& node : all) node.weight *= weightOfElevation(node);
    const auto between = samplesAt(source, uniformPairs(count, seed + 1), threads);
    all.insert(all.end(), between.begin(), between.end());
    return datasetInMemory(std::move(all));
}

}  // namespace

Dataset makeDataset(const Source& source, size_t count, uint64_t seed, int threads)
{
    if (hasSamples(source)) {
        Dataset dataset = datasetOfSamples(source, threads);
        if (source.evaluate && dataset.rows < count)
            dataset = withFunction(dataset, source, count, seed, threads);
        dataset.exact = source.exact;
        return dataset;
    }
    if (!source.evaluate)
        throw Error(ErrorKind::fit, source.name.empty() ? "source" : source.name,
                    Found("neither samples nor a function").expected("one of them"));
    Dataset dataset = datasetInMemory(samplesAt(source, uniformPairs(count, seed + 1), threads));
    dataset.exact = true;
    return dataset;
}

Dataset datasetInMemory(std::vector<Sample> samples)
{
    const auto owner = std::make_shared<const std::vector<Sample>>(std::move(samples));
    return datasetOf(owner, *owner);
}

Dataset datasetOfStream(const SampleStream& stream)
{
    Dataset dataset;
    dataset.rows = stream.rows;
    dataset.read = [&stream](uint64_t first, size_t count, DatasetScratch& scratch) {
        return readPieces(stream, first, count, scratch);
    };
    return dataset;
}

DatasetBlock Dataset::block(size_t index, DatasetScratch& scratch) const
{
    FBRDF_ASSERT(index, <, blocks());
    const uint64_t first = index * kBlockRows;
    return read(first, static_cast<size_t>(std::min<uint64_t>(kBlockRows, rows - first)), scratch);
}

// Words are multiplied in pairs, each plus a constant of its own: products of one sample do not
// wait for each other (Black et al. 1999, "UMAC": NH).
std::string geometryOf(const Dataset& dataset, int threads)
{
    if (!dataset.inMemory) return {};
    std::vector<uint64_t> hashes(dataset.blocks(), 0);
    parallelTasks(hashes.size(), threads, [&](size_t b) {
        DatasetScratch scratch;
        const DatasetBlock block = dataset.block(b, scratch);
        std::array<uint32_t, 8> words{}, keys;
        for (size_t w = 0; w < keys.size(); ++w) keys[w] = static_cast<uint32_t>(splitMix64(w + 1));
        for (size_t i = 0; i < block.count; ++i) {
            const Sample& s = block.samples[i];
            const float numbers[7] = {s.wo.x, s.wo.y, s.wo.z, s.wi.x, s.wi.y, s.wi.z, s.weight};
            std::memcpy(words.data(), numbers, sizeof numbers);
            uint64_t sum = hashes[b];
            for (size_t w = 0; w < words.size(); w += 2)
                sum += uint64_t{words[w] + keys[w]} * uint64_t{words[w + 1] + keys[w + 1]};
            hashes[b] = splitMix64(sum);
        }
    });
    uint64_t hash = dataset.rows;
    for (const uint64_t part : hashes) hash = splitMix64(hash ^ part);
    return std::to_string(dataset.rows) + " rows " + std::to_string(hash);
}

double FoldChoice::share() const
{
    if (only != kNoFold) return 1.0 / kFolds;
    return without == kNoFold ? 1.0 : 1.0 - 1.0 / kFolds;
}

std::vector<Sample> someSamples(const Dataset& dataset, const FoldChoice& choice, size_t limit,
                                uint64_t seed, int threads)
{
    const Ranges ranges = rangesFor(dataset, wantedRows(choice, limit));
    const auto most = static_cast<double>(limit),
               seen = choice.share() *
                      double(std::min<uint64_t>(dataset.rows, ranges.count * ranges.length));
    // A regular stride would beat with the grid of a measurement: a hash decides. Four standard
    // deviations fewer than the limit are expected, so that it cuts nothing off at the end.
    const bool every = seen <= most;
    const auto bound = every ? uint64_t{0}
                             : static_cast<uint64_t>(std::ldexp(
                                   std::max(0.0, most - 4.0 * std::sqrt(most)) / seen, 64));
    std::vector<std::vector<Sample>> parts(ranges.count);
    parallelTasks(ranges.count, threads, [&](size_t r) {
        const uint64_t first = r * ranges.distance;
        const auto length =
            static_cast<size_t>(std::min<uint64_t>(ranges.length, dataset.rows - first));
        DatasetScratch scratch;
        const DatasetBlock block = dataset.read(first, length, scratch);
        for (size_t i = 0; i < block.count; ++i) {
            const uint64_t number = block.number(i);
            if (!every && splitMix64(number ^ ~seed) >= bound) continue;
            if (choice.isAll() || choice.has(foldOf(number, seed)))
                parts[r].push_back(block.samples[i]);
        }
    });
    return joined(parts, limit);
}

}  // namespace fbrdf

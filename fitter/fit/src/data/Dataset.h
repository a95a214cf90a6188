// Dataset.h - the samples of a source in ranges that can be read in any order, from any thread,
// again and again. Fits read them once a pass and keep none, so memory does not grow with the
// number of samples.
#pragma once
#include <fbrdf/base/SplitMix.h>

#include <fbrdf/sources/Source.h>

#include <functional>
#include <string>
#include <vector>

namespace fbrdf {

constexpr size_t kPieceRows = 256;              ///< rows that are read at once from a stream
constexpr size_t kBlockRows = 32 * kPieceRows;  ///< rows a block at most
constexpr int kFolds = 5;
constexpr int kNoFold = -1;

/// The samples of a range of rows, each with a number that does not depend on the range in which it
/// was read. Where a stream drops rows, numbers are skipped.
struct DatasetBlock {
    const Sample* samples = nullptr;
    size_t count = 0;
    uint64_t first = 0;                 ///< number of the range's first row
    const uint16_t* offsets = nullptr;  ///< sample i has the number first + offsets[i]; null: i

    uint64_t number(size_t i) const { return first + (offsets ? offsets[i] : i); }
};

/// Storage of what a stream made, used again from read to read.
struct DatasetScratch {
    std::vector<Sample> samples;
    std::vector<uint16_t> offsets;
};

struct Dataset {
    size_t rows = 0;        ///< samples at most
    bool exact = false;     ///< values of a function: no noise, no outliers
    bool inMemory = false;  ///< reading costs nothing
    /// The samples among rows [first, first + count), first a multiple of kPieceRows and count at
    /// most kBlockRows; the view is valid until the next read into the same scratch.
    std::function<DatasetBlock(uint64_t first, size_t count, DatasetScratch& scratch)> read;

    size_t blocks() const { return (rows + kBlockRows - 1) / kBlockRows; }
    DatasetBlock block(size_t index, DatasetScratch& scratch) const;
};

/// Samples of the source itself, in memory or streamed; `count` of its uniform pairs where it is
/// only a function, and beside samples that are fewer; these then count less near the horizon, by
/// c^4 / (c^4 + 0.1^4) of both cosines. The source must outlive the dataset.
Dataset makeDataset(const Source& source, size_t count, uint64_t seed, int threads);

/// The samples given, kept in memory.
Dataset datasetInMemory(std::vector<Sample> samples);

/// The samples of a stream, made again whenever they are read. The stream must outlive the dataset.
Dataset datasetOfStream(const SampleStream& stream);

/// Equal for two datasets whose row k is the same pair with the same weight for every k (but for
/// one chance in 2^64); empty for a dataset that is not in memory.
std::string geometryOf(const Dataset& dataset, int threads);

/// The fold of a sample, below kFolds. Folds show no pattern of the measurement.
inline int foldOf(uint64_t number, uint64_t seed)
{
    return static_cast<int>(splitMix64(number ^ splitMix64(seed)) % kFolds);
}

/// All samples, those of one fold, or all but those of one.
struct FoldChoice {
    int only = kNoFold, without = kNoFold;

    static FoldChoice all() { return {}; }
    static FoldChoice onlyOf(int fold) { return {fold, kNoFold}; }
    static FoldChoice allBut(int fold) { return {kNoFold, fold}; }
    bool isAll() const { return only == kNoFold && without == kNoFold; }
    bool has(int fold) const { return only == kNoFold ? fold != without : fold == only; }
    /// The share of all samples that is chosen.
    double share() const;
};

/// Chosen samples spread over the whole dataset, `limit` at most. A long stream is looked into here
/// and there, not read through.
std::vector<Sample> someSamples(const Dataset& dataset, const FoldChoice& choice, size_t limit,
                                uint64_t seed, int threads = 0);

}  // namespace fbrdf

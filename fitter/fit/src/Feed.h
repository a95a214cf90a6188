// Feed.h - the samples of a source in blocks that can be read in any order, from any thread, again
// and again. Fits read them once a pass and hold none, so memory does not grow with the number of
// samples.
#pragma once
#include <fbrdf/sources/Source.h>

#include <functional>
#include <vector>

namespace fbrdf {

constexpr size_t kFeedBlock = 8192;  ///< rows a block at most
constexpr int kFolds = 5;
constexpr int kNoFold = -1;

struct FeedBlock {
    const Sample* samples = nullptr;
    size_t count = 0;
    uint64_t first = 0;  ///< number of the first sample; numbers need not be contiguous over blocks
};

struct Feed {
    size_t blocks = 0;
    size_t rows = 0;     ///< samples at most
    bool exact = false;  ///< values of a function: no noise, no outliers
    /// The view is valid until the next read into the same scratch.
    std::function<FeedBlock(size_t block, std::vector<Sample>& scratch)> read;
};

/// Samples, held or streamed, of the source itself; `count` of its uniform pairs where it is only a
/// function. The source must outlive the feed.
Feed makeFeed(const Source& source, size_t count, uint64_t seed, int threads);

/// Which of kFolds a sample belongs to.
int foldOf(uint64_t number, uint64_t seed);

/// Samples spread over all blocks, `limit` at most; of one fold, or of all with kNoFold.
std::vector<Sample> someSamples(const Feed& feed, int fold, size_t limit, uint64_t seed);

}  // namespace fbrdf

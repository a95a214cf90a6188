#include "Feed.h"

#include "Mixed.h"
#include "Parallel.h"

#include <fbrdf/brdf/Error.h>
#include <fbrdf/fit/SampleSets.h>

#include <algorithm>
#include <memory>

namespace fbrdf {
namespace {

// A stream of at most this many rows (a MERL file, twice) is read once and held; 40 bytes a row.
constexpr size_t kHeldRows = 3000000;

size_t blocksOf(size_t rows)
{
    return (rows + kFeedBlock - 1) / kFeedBlock;
}

Feed feedOf(std::shared_ptr<const std::vector<Sample>> owner, const std::vector<Sample>& samples)
{
    Feed feed;
    feed.rows = samples.size();
    feed.blocks = blocksOf(feed.rows);
    feed.read = [owner = std::move(owner), &samples](size_t block, std::vector<Sample>&) {
        const size_t first = block * kFeedBlock;
        return FeedBlock{samples.data() + first, std::min(kFeedBlock, samples.size() - first),
                         first};
    };
    return feed;
}

Feed feedOf(const SampleStream& stream)
{
    Feed feed;
    feed.rows = stream.rows;
    feed.blocks = blocksOf(feed.rows);
    feed.read = [&stream](size_t block, std::vector<Sample>& scratch) {
        const uint64_t first = block * kFeedBlock;
        SampleReport report;
        scratch.clear();
        stream.read(first, std::min<uint64_t>(kFeedBlock, stream.rows - first), scratch, report);
        return FeedBlock{scratch.data(), scratch.size(), first};
    };
    return feed;
}

std::shared_ptr<const std::vector<Sample>> allSamples(const Feed& feed, int threads)
{
    std::vector<std::vector<Sample>> blocks(feed.blocks);
    parallelTasks(feed.blocks, threads, [&](size_t b) { feed.read(b, blocks[b]); });
    auto all = std::make_shared<std::vector<Sample>>();
    all->reserve(feed.rows);
    for (const auto& block : blocks) all->insert(all->end(), block.begin(), block.end());
    return all;
}

}  // namespace

Feed makeFeed(const Source& source, size_t count, uint64_t seed, int threads)
{
    if (!source.samples.empty()) return feedOf(nullptr, source.samples);
    if (source.stream) {
        const Feed stream = feedOf(source.stream);
        if (stream.rows > kHeldRows) return stream;
        const auto held = allSamples(stream, threads);
        return feedOf(held, *held);
    }
    if (!source.evaluate)
        throw Error(ErrorKind::fit, source.name.empty() ? "source" : source.name,
                    "found neither samples nor a function, expected one of them");
    const auto taken = std::make_shared<const std::vector<Sample>>(
        samplesAt(source, uniformPairs(count, seed + 1), threads));
    Feed feed = feedOf(taken, *taken);
    feed.exact = true;
    return feed;
}

// Folds show no pattern of the measurement.
int foldOf(uint64_t number, uint64_t seed)
{
    return static_cast<int>(mixed(number ^ mixed(seed)) % kFolds);
}

std::vector<Sample> someSamples(const Feed& feed, int fold, size_t limit, uint64_t seed)
{
    const size_t available = fold == kNoFold ? feed.rows : feed.rows / kFolds;
    const uint64_t stride = std::max<uint64_t>(1, available / std::max<size_t>(1, limit));
    std::vector<Sample> chosen, scratch;
    uint64_t met = 0;
    for (size_t b = 0; b < feed.blocks && chosen.size() < limit; ++b) {
        const FeedBlock block = feed.read(b, scratch);
        for (size_t i = 0; i < block.count && chosen.size() < limit; ++i) {
            if (fold != kNoFold && foldOf(block.first + i, seed) != fold) continue;
            // A regular stride would beat with the grid of a measurement; the hash picks one in
            // `stride`.
            if (stride > 1 && mixed(met++ ^ ~seed) % stride != 0) continue;
            chosen.push_back(block.samples[i]);
        }
    }
    return chosen;
}

}  // namespace fbrdf

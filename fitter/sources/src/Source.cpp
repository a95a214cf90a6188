#include <fbrdf/sources/Source.h>

#include <algorithm>

namespace fbrdf {

SampleReport& SampleReport::operator+=(const SampleReport& other)
{
    given += other.given;
    nonFinite += other.nonFinite;
    belowHorizon += other.belowHorizon;
    invalid += other.invalid;
    negative += other.negative;
    zero += other.zero;
    outOfGamut += other.outOfGamut;
    return *this;
}

bool hasSamples(const Source& source)
{
    return !source.samples.empty() || source.stream;
}

void SampleStream::operator()(const SampleVisitor& visit) const
{
    std::vector<Sample> block;
    SampleReport ignored;
    for (uint64_t first = 0; first < rows; first += kSampleBlock) {
        block.clear();
        read(first, static_cast<size_t>(std::min<uint64_t>(kSampleBlock, rows - first)), block,
             ignored);
        if (!block.empty()) visit(block.data(), block.size());
    }
}

void forEachBlock(const Source& source, const SampleVisitor& visit)
{
    const std::vector<Sample>& held = source.samples;
    for (size_t first = 0; first < held.size(); first += kSampleBlock)
        visit(held.data() + first, std::min(kSampleBlock, held.size() - first));
    if (source.stream) source.stream(visit);
}

SampleReport reportOf(const Source& source)
{
    SampleReport report = source.report;
    if (!source.stream) return report;
    std::vector<Sample> block;
    for (uint64_t first = 0; first < source.stream.rows; first += kSampleBlock) {
        block.clear();
        const uint64_t count = std::min<uint64_t>(kSampleBlock, source.stream.rows - first);
        source.stream.read(first, static_cast<size_t>(count), block, report);
    }
    return report;
}

}  // namespace fbrdf

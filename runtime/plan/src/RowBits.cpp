#include "RowBits.h"

#include <algorithm>

namespace fbrdf {
namespace {

constexpr size_t kBits = 64;

/// Warren 2013, Hacker's Delight, section 5-1.
int numberOfBits(uint64_t bits)
{
    constexpr uint64_t kPairs = 0x5555555555555555u, kFours = 0x3333333333333333u,
                       kBytes = 0x0f0f0f0f0f0f0f0fu, kOnes = 0x0101010101010101u;
    bits -= (bits >> 1) & kPairs;
    bits = (bits & kFours) + ((bits >> 2) & kFours);
    bits = (bits + (bits >> 4)) & kBytes;
    return static_cast<int>((bits * kOnes) >> 56);
}

/// Writes the lights of the bits that are set; returns where it has ended. last: nothing is written
/// from there on. kAtOnce: entries that are written in a step, needed or not.
template <int kAtOnce>
int32_t* addLights(uint64_t bits, const ColumnSpan* spans, int32_t* out, const int32_t* last)
{
    constexpr uint64_t kHighest = uint64_t(1) << (kBits - 1);  // so that there always is a bit
    const int count = numberOfBits(bits);
    int32_t* const end = out + count;
    if (last - end < kAtOnce) {
        for (; out < end; ++out, bits &= bits - 1) *out = spans[__builtin_ctzll(bits)].light;
        return end;
    }
    do {
        for (int i = 0; i < kAtOnce; ++i, bits &= bits - 1)
            out[i] = spans[__builtin_ctzll(bits | kHighest)].light;
        out += kAtOnce;
    } while (out < end);
    return end;
}

}  // namespace

template <int kAtOnce>
void RowBits::addLists(const ListRow& row, int columns, int32_t first, int32_t end, int32_t* lists,
                       int32_t* indices)
{
    const size_t words = spans_.size();
    int32_t* out = indices + first;
    for (int column = 0; column < columns; ++column) {
        uint64_t* const ends = ends_.data() + static_cast<size_t>(column) * words;
        int32_t* const begin = out;
        for (size_t k = 0; k < words; ++k) {
            spans_[k] ^= ends[k];
            ends[k] = 0;
            out = addLights<kAtOnce>(spans_[k], row.spans.data() + k * kBits, out, indices + end);
        }
        lists[2 * column] = static_cast<int32_t>(begin - indices);
        lists[2 * column + 1] = static_cast<int32_t>(out - begin);
    }
    std::fill_n(ends_.data() + static_cast<size_t>(columns) * words, words, 0);
}

void RowBits::makeLists(const ListRow& row, int columns, int32_t first, int32_t end, int32_t* lists,
                        int32_t* indices)
{
    const size_t words = (row.used + kBits - 1) / kBits,
                 all = (static_cast<size_t>(columns) + 1) * words;
    if (ends_.size() < all) ends_.resize(all);
    for (size_t k = 0; k < row.used; ++k) {
        const ColumnSpan& span = row.spans[k];
        const uint64_t bit = uint64_t(1) << (k % kBits);
        uint64_t* const word = ends_.data() + k / kBits;
        word[static_cast<size_t>(span.first) * words] ^= bit;
        word[static_cast<size_t>(span.last) * words] ^= bit;
    }
    spans_.assign(words, 0);
    constexpr size_t kFew = 4;  // of 64
    if (row.entries < kFew * all)
        addLists<4>(row, columns, first, end, lists, indices);
    else
        addLists<8>(row, columns, first, end, lists, indices);
}

}  // namespace fbrdf

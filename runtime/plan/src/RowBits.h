// RowBits.h - the lists of the tiles of a row, from the spans of its lights.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fbrdf {

/// A light in the tiles [first, last) of a row.
struct ColumnSpan {
    int32_t light;
    int16_t first, last;
};

/// The lights of a row of tiles, by slot.
struct ListRow {
    /// Memory of a multiple of 64 spans, as RowBits looks at 64 at once.
    std::vector<ColumnSpan> spans;
    size_t used = 0;     ///< the first so many of `spans`
    size_t entries = 0;  ///< of the lists of all tiles together

    void clear() { used = entries = 0; }
    /// Drops an empty span, without a branch that processors would guess wrong.
    void add(int32_t light, int firstColumn, int lastColumn)
    {
        if (used == spans.size()) spans.resize(2 * used + 64);
        spans[used] = {light, static_cast<int16_t>(firstColumn), static_cast<int16_t>(lastColumn)};
        const int length = firstColumn < lastColumn ? lastColumn - firstColumn : 0;
        used += length > 0 ? 1 : 0;
        entries += static_cast<size_t>(length);
    }
};

/// A matrix of bits, one for each tile of a row and each of its spans. Only the ends of spans are
/// written; whether a tile is in a span follows from the tile before it, for 64 spans at once.
class RowBits {
public:
    /// Writes first index and number of each tile into lists, of 2 x columns, and the lights of
    /// the tiles one after another into indices[first] to indices[first + row.entries]. Nothing is
    /// written from indices[end] on, end >= first + row.entries; what is between may be.
    void makeLists(const ListRow& row, int columns, int32_t first, int32_t end, int32_t* lists,
                   int32_t* indices);

private:
    template <int kAtOnce>
    void addLists(const ListRow& row, int columns, int32_t first, int32_t end, int32_t* lists,
                  int32_t* indices);

    std::vector<uint64_t> ends_;   ///< of each tile, and of one behind the last; 0 between calls
    std::vector<uint64_t> spans_;  ///< in which a tile is
};

}  // namespace fbrdf

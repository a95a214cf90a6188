// Lists of a row from bits, against one entry after another.
#include "RowBits.h"

#include <gtest/gtest.h>

#include <random>

namespace fbrdf {
namespace {

constexpr int32_t kUntouched = -7;

/// What makeLists gives for a row that begins at `first` in memory that goes on after it.
struct MadeRow {
    std::vector<int32_t> lists, indices;
};

MadeRow made(RowBits& bits, const ListRow& row, int columns, int32_t first)
{
    const int32_t end = first + static_cast<int32_t>(row.entries);
    MadeRow result{std::vector<int32_t>(2 * static_cast<size_t>(columns), kUntouched),
                   std::vector<int32_t>(static_cast<size_t>(end) + 16, kUntouched)};
    bits.makeLists(row, columns, first, end, result.lists.data(), result.indices.data());
    return result;
}

std::vector<int32_t> listOf(const MadeRow& row, int column)
{
    const auto at = 2 * static_cast<size_t>(column);
    const auto first = row.indices.begin() + row.lists[at];
    return {first, first + row.lists[at + 1]};
}

/// Compares with the lights of every column, and what is around the row with what was there.
void expectLists(const MadeRow& row, const std::vector<ColumnSpan>& spans, int columns,
                 int32_t first, size_t entries)
{
    size_t sum = 0;
    for (int column = 0; column < columns; ++column) {
        std::vector<int32_t> expected;
        for (const ColumnSpan& span : spans)
            if (span.first <= column && column < span.last) expected.push_back(span.light);
        ASSERT_EQ(listOf(row, column), expected) << column;
        sum += expected.size();
    }
    EXPECT_EQ(sum, entries);
    for (size_t i = 0; i < row.indices.size(); ++i) {
        const bool isInside =
            i >= static_cast<size_t>(first) && i - static_cast<size_t>(first) < entries;
        ASSERT_TRUE(isInside || row.indices[i] == kUntouched) << i;
    }
}

TEST(RowBits, ListTheLightsOfEveryTile)
{
    std::mt19937 random(41);
    RowBits bits;  // one for all rows, so that what is left of one would show in the next
    for (const int columns : {1, 7, 48, 300})
        for (const int lights : {0, 1, 63, 64, 65, 1000})
            for (const int longest : {1, 5, columns}) {
                std::uniform_int_distribution<int> place(0, columns), length(-2, longest);
                ListRow row;
                std::vector<ColumnSpan> spans;
                for (int light = 0; light < lights; ++light) {
                    const int from = place(random), to = std::min(columns, from + length(random));
                    row.add(3 * light, from, to);
                    if (from < to)
                        spans.push_back(
                            {3 * light, static_cast<int16_t>(from), static_cast<int16_t>(to)});
                }
                EXPECT_EQ(row.used, spans.size());
                expectLists(made(bits, row, columns, 5), spans, columns, 5, row.entries);
            }
}

TEST(RowBits, StayInOrderWhereARowIsUsedAgain)
{
    RowBits bits;
    ListRow row;
    for (int32_t light = 0; light < 200; ++light) row.add(light, 0, 9);
    EXPECT_EQ(row.entries, 1800u);
    EXPECT_EQ(listOf(made(bits, row, 9, 0), 8).back(), 199);
    row.clear();
    row.add(4, 2, 3);
    expectLists(made(bits, row, 9, 0), {{4, 2, 3}}, 9, 0, 1);
}

}  // namespace
}  // namespace fbrdf

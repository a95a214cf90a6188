#include "ListEdits.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace fbrdf {
namespace {

bool isBefore(const LightSpan& a, const LightSpan& b)
{
    return std::tie(a.slice, a.row) < std::tie(b.slice, b.row);
}

}  // namespace

ListEditor::ListEditor(LightClusters& clusters, const ClusterTiles& tiles, KnownLights& known,
                       EditMemory& memory, size_t most)
    : clusters_(clusters), tiles_(tiles), known_(known), memory_(memory), left_(most)
{
    if (!memory.rooms.empty()) return;
    for (size_t k = 1; k < clusters.lists.size(); k += 2) memory.rooms.push_back(clusters.lists[k]);
}

bool ListEditor::apply(const LightChange& change, const LightVectors& light)
{
    const auto place = static_cast<size_t>(change.place);
    const bool wasSeen = known_.slots[place] >= 0;
    memory_.before.clear();
    memory_.after.clear();
    if (wasSeen) addSpansOf(known_.reaches[place], memory_.before);
    if (!wasSeen) {
        known_.slots[place] = static_cast<int32_t>(clusters_.lights.size());
        clusters_.lights.emplace_back();
        clusters_.places.push_back(change.place);
    }
    const int32_t slot = known_.slots[place];
    if (change.isSeen) {
        addSpansOf(change.reach, memory_.after);
        clusters_.lights[static_cast<size_t>(slot)] = light;
        known_.reaches[place] = change.reach;
    }
    changeLists(slot);
    if (!change.isSeen) freeSlot(slot);
    return left_ > 0;
}

void ListEditor::addSpansOf(const Reach& reach, std::vector<LightSpan>& spans) const
{
    const auto [first, last] = tiles_.slicesOf(reach);
    for (int slice = first; slice < last; ++slice)
        addSpans(tiles_, slice, 0, clusters_.grid.rows, 0, reach, spans);
}

/// Walks through the rows of both, which ascend.
void ListEditor::changeLists(int32_t slot)
{
    auto before = memory_.before.cbegin(), after = memory_.after.cbegin();
    const auto beforeEnd = memory_.before.cend(), afterEnd = memory_.after.cend();
    while (before != beforeEnd || after != afterEnd) {
        if (after == afterEnd || (before != beforeEnd && isBefore(*before, *after))) {
            changeRow(*before, before->first, before->last, 0, 0, slot);
            ++before;
        } else if (before == beforeEnd || isBefore(*after, *before)) {
            changeRow(*after, 0, 0, after->first, after->last, slot);
            ++after;
        } else {
            changeRow(*after, before->first, before->last, after->first, after->last, slot);
            ++before;
            ++after;
        }
    }
}

void ListEditor::changeRow(const LightSpan& row, int outFirst, int outLast, int inFirst, int inLast,
                           int32_t slot)
{
    for (int column = outFirst; column < outLast; ++column)
        if (column < inFirst || column >= inLast) takeOut(clusterOf(row, column), slot);
    for (int column = inFirst; column < inLast; ++column)
        if (column < outFirst || column >= outLast) putIn(clusterOf(row, column), slot);
}

size_t ListEditor::clusterOf(const LightSpan& row, int column) const
{
    const ClusterGrid& grid = clusters_.grid;
    return static_cast<size_t>((row.slice * grid.rows + row.row) * grid.columns + column);
}

int32_t* ListEditor::find(size_t cluster, int32_t slot) const
{
    int32_t* const first = clusters_.indices.data() + clusters_.lists[2 * cluster];
    const std::vector<int32_t>& places = clusters_.places;
    const int32_t place = places[static_cast<size_t>(slot)];
    return std::lower_bound(first, first + clusters_.lists[2 * cluster + 1], place,
                            [&](int32_t listed, int32_t wanted) {
                                return places[static_cast<size_t>(listed)] < wanted;
                            });
}

void ListEditor::takeOut(size_t cluster, int32_t slot)
{
    if (left_ == 0) return;
    --left_;
    int32_t* const at = find(cluster, slot);
    int32_t& count = clusters_.lists[2 * cluster + 1];
    int32_t* const end = clusters_.indices.data() + clusters_.lists[2 * cluster] + count;
    std::copy(at + 1, end, at);
    --count;
    --memory_.entries;
}

void ListEditor::putIn(size_t cluster, int32_t slot)
{
    if (left_ == 0) return;
    --left_;
    int32_t& count = clusters_.lists[2 * cluster + 1];
    if (count == memory_.rooms[cluster]) makeRoom(cluster);
    if (left_ == 0) return;
    int32_t* const at = find(cluster, slot);
    int32_t* const end = clusters_.indices.data() + clusters_.lists[2 * cluster] + count;
    std::copy_backward(at, end, end + 1);
    *at = slot;
    ++count;
    ++memory_.entries;
}

/// Moves a list to the end of all, where it may grow. The place it leaves stays unused until all
/// lists are made anew.
void ListEditor::makeRoom(size_t cluster)
{
    constexpr size_t kMost = std::numeric_limits<int32_t>::max();
    const auto first = static_cast<size_t>(clusters_.lists[2 * cluster]),
               count = static_cast<size_t>(clusters_.lists[2 * cluster + 1]),
               room = count + count / 4 + 4, end = clusters_.indices.size();
    if (end + room > std::min(kMost, 2 * memory_.entries + (size_t(1) << 16))) {
        left_ = 0;
        return;
    }
    clusters_.indices.resize(end + room);
    std::copy_n(clusters_.indices.begin() + static_cast<std::ptrdiff_t>(first), count,
                clusters_.indices.begin() + static_cast<std::ptrdiff_t>(end));
    clusters_.lists[2 * cluster] = static_cast<int32_t>(end);
    memory_.rooms[cluster] = static_cast<int32_t>(room);
}

/// The last light takes the slot of one that is in no list any more.
void ListEditor::freeSlot(int32_t slot)
{
    const auto last = static_cast<int32_t>(clusters_.lights.size()) - 1;
    const auto freed = static_cast<size_t>(slot), moved = static_cast<size_t>(last);
    known_.slots[static_cast<size_t>(clusters_.places[freed])] = -1;
    if (slot != last) {
        const auto place = static_cast<size_t>(clusters_.places[moved]);
        memory_.before.clear();
        addSpansOf(known_.reaches[place], memory_.before);
        for (const LightSpan& span : memory_.before)
            for (int column = span.first; left_ > 0 && column < span.last; ++column, --left_)
                *find(clusterOf(span, column), last) = slot;
        clusters_.lights[freed] = clusters_.lights[moved];
        clusters_.places[freed] = clusters_.places[moved];
        known_.slots[place] = slot;
    }
    clusters_.lights.pop_back();
    clusters_.places.pop_back();
}

}  // namespace fbrdf

#include "ClusterSpans.h"

#include <cmath>

namespace fbrdf {
namespace {

// Rows of which spans are found side by side: nothing in those loops branches.
constexpr int kRows = 32;

/// Ends of spans in rows of a slice; last <= first where there is none.
struct Ends {
    int first[kRows], last[kRows];
};

/// What one sphere has in common in all rows of a slice.
struct SliceDisc {
    double x, y, radiusSquared;  ///< of its largest section parallel to the picture
};

/// The ends in `count` <= kRows rows from `row` on.
void setEnds(const Tiles& tiles, const SliceDisc& disc, int row, int count, Ends& ends)
{
    const TileAxis& columns = tiles.columns;
    const double* const lows = &tiles.rows.lows[static_cast<size_t>(row)];
    const double* const highs = &tiles.rows.highs[static_cast<size_t>(row)];
    const double perNear = columns.perNear, perFar = columns.perFar;
    const double nearAt = (disc.x - columns.lines.x) * perNear,
                 farAt = (disc.x - columns.lines.z) * perFar,
                 all = static_cast<double>(columns.count());
    // The columns of a mirrored projection descend, and what is per unit is negative.
    const double widthNear = std::abs(perNear), widthFar = std::abs(perFar);
    for (int i = 0; i < count; ++i) {
        const double below = lows[i] - disc.y, above = disc.y - highs[i];
        double away = below > above ? below : above;
        away = away > 0.0 ? away : 0.0;
        const double left = disc.radiusSquared - away * away;
        const double half = std::sqrt(left > 0.0 ? left : 0.0);
        const double nearHalf = half * widthNear, farHalf = half * widthFar;
        double first = std::min(nearAt - nearHalf, farAt - farHalf) - kTileMargin,
               last = std::max(nearAt + nearHalf, farAt + farHalf) + kTileMargin + 1.0;
        first = first > 0.0 ? first : 0.0;
        first = first < all ? first : all;
        last = last > 0.0 ? last : 0.0;
        last = last < all ? last : all;
        // Conversions to int round towards 0, which for what is not negative is down.
        ends.first[i] = static_cast<int>(first);
        ends.last[i] = left < 0.0 ? 0 : static_cast<int>(last);
    }
}

/// The same for degenerate projections, where only the extent of a tile tells.
void setEndsTileByTile(const Tiles& tiles, const SliceDisc& disc, int row, int count, Ends& ends)
{
    for (int i = 0; i < count; ++i) {
        const double left =
            disc.radiusSquared - square(intervalDistance(tiles.rows.extent(row + i), disc.y));
        const auto isMet = [&](int column) {
            return square(intervalDistance(tiles.columns.extent(column), disc.x)) <= left;
        };
        int first = 0, last = static_cast<int>(tiles.columns.count());
        while (first < last && !isMet(first)) ++first;
        while (first < last && !isMet(last - 1)) --last;
        ends.first[i] = first;
        ends.last[i] = last;
    }
}

/// A cone in a row of tiles.
class ConeInRow {
public:
    ConeInRow(const Tiles& tiles, const Reach& cone, int row) : columns_(tiles.columns), cone_(cone)
    {
        const DistanceRange<double> y = tiles.rows.extent(row);
        centre_ = {0.0, 0.5 * (y.low + y.high), -0.5 * (tiles.distance.low + tiles.distance.high)};
        half_ = {0.0, 0.5 * (y.high - y.low), 0.5 * (tiles.distance.high - tiles.distance.low)};
    }

    /// Drops tiles at either end of [first, last) that the cone misses.
    void trim(int& first, int& last)
    {
        if (first >= last) return;
        // Most often all of them are missed, or none at the ends.
        if (!mayBeIn(first, last - 1)) last = first;
        if (last - first <= 1) return;
        while (first < last && !mayBeIn(first, first)) ++first;
        while (first < last && !mayBeIn(last - 1, last - 1)) --last;
    }

private:
    /// True where some of the cone may be in the tiles from one to another.
    bool mayBeIn(int from, int to)
    {
        // The columns of a mirrored projection descend.
        const DistanceRange<double> a = columns_.extent(from), b = columns_.extent(to);
        const double low = std::min(a.low, b.low), high = std::max(a.high, b.high);
        centre_.x = 0.5 * (low + high);
        half_.x = 0.5 * (high - low);
        return !coneMissesBox(centre_ - cone_.apex, half_ * kDistanceMargin, cone_.axis,
                              cone_.cosine, cone_.sine);
    }

    const TileAxis& columns_;
    const Reach& cone_;
    Vec3d centre_{0.0}, half_{0.0};
};

}  // namespace

void addSpans(const ClusterTiles& all, int slice, int firstRow, int lastRow, int32_t light,
              const Reach& reach, std::vector<LightSpan>& spans)
{
    const Tiles& tiles = all[slice];
    const double radius = reach.radius * kDistanceMargin,
                 depth = intervalDistance(tiles.distance, -reach.centre.z);
    const SliceDisc disc{reach.centre.x, reach.centre.y, square(radius) - square(depth)};
    if (disc.radiusSquared < 0.0 || tiles.distance.low > tiles.distance.high) return;
    const double half = std::sqrt(disc.radiusSquared);
    const auto [metFirst, metLast] = tiles.rows.metBy(disc.y - half, disc.y + half);
    const int begin = std::max(metFirst, firstRow), end = std::min(metLast, lastRow);
    const auto setAll = tiles.columns.isOrdered() ? setEnds : setEndsTileByTile;
    for (int row = begin; row < end; row += kRows) {
        Ends ends;
        const int count = std::min(kRows, end - row);
        setAll(tiles, disc, row, count, ends);
        if (reach.hasCone())
            for (int i = 0; i < count; ++i)
                ConeInRow(tiles, reach, row + i).trim(ends.first[i], ends.last[i]);
        LightSpan found[kRows];
        int spansFound = 0;
        for (int i = 0; i < count; ++i) {
            found[spansFound] = {light, static_cast<int16_t>(slice), static_cast<int16_t>(row + i),
                                 static_cast<int16_t>(ends.first[i]),
                                 static_cast<int16_t>(ends.last[i])};
            spansFound += ends.first[i] < ends.last[i] ? 1 : 0;
        }
        spans.insert(spans.end(), found, found + spansFound);
    }
}

}  // namespace fbrdf

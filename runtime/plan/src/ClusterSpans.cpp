#include "ClusterSpans.h"

#include <cmath>

namespace fbrdf {
namespace {

/// What one sphere has in common in all rows of a slice.
struct SliceDisc {
    double x, y, radiusSquared;  ///< of its largest section parallel to the picture
};

/// The largest coordinate of the edges of rows.
double farthestOf(const TileAxis& rows, const RowEnds& ends)
{
    const DistanceRange<double> a = rows.extent(ends.row),
                                b = rows.extent(ends.row + ends.count - 1);
    return std::max(std::max(std::abs(a.low), std::abs(a.high)),
                    std::max(std::abs(b.low), std::abs(b.high)));
}

/// True where floats have room for what setEnds computes.
bool fitsFloats(const Tiles& tiles, const SliceDisc& disc, const RowEnds& ends)
{
    constexpr double kLarge = 1e30, kSmall = 1e-30;
    const TileAxis& columns = tiles.columns;
    return disc.radiusSquared > kSmall && disc.radiusSquared < kLarge &&
           square(std::abs(disc.y) + farthestOf(tiles.rows, ends)) < kLarge &&
           (std::abs(disc.x) + std::abs(columns.lines.x) + std::abs(columns.lines.z) +
            std::sqrt(disc.radiusSquared)) *
                   (std::abs(columns.perNear) + std::abs(columns.perFar)) <
               kLarge;
}

/// Nothing in the loop branches, and floats let processors take four rows in a step. Whatever
/// floats round makes spans longer.
void setEnds(const Tiles& tiles, const SliceDisc& disc, RowEnds& ends)
{
    constexpr double kRounding = 1e-6;  // above that of a few operations in float, relative
    const TileAxis& columns = tiles.columns;
    const float* const lows = &tiles.rows.floatLows[static_cast<size_t>(ends.row)];
    const float* const highs = &tiles.rows.floatHighs[static_cast<size_t>(ends.row)];
    const double nearMiddle = (disc.x - columns.lines.x) * columns.perNear,
                 farMiddle = (disc.x - columns.lines.z) * columns.perFar;
    const auto slack = static_cast<float>(kRounding *
                                          (std::abs(disc.y) + farthestOf(tiles.rows, ends))),
               margin = static_cast<float>(
                   kTileMargin +
                   kRounding * (1.0 + std::max(std::abs(nearMiddle), std::abs(farMiddle)))),
               y = static_cast<float>(disc.y),
               radiusSquared = static_cast<float>(disc.radiusSquared * (1.0 + kRounding)),
               nearAt = static_cast<float>(nearMiddle), farAt = static_cast<float>(farMiddle),
               all = static_cast<float>(columns.count());
    // The columns of a mirrored projection descend, and what is per unit is negative.
    const auto widthNear = static_cast<float>(std::abs(columns.perNear) * (1.0 + kRounding)),
               widthFar = static_cast<float>(std::abs(columns.perFar) * (1.0 + kRounding));
    // Whole steps: what is computed beyond the last row is not used.
    for (int from = 0; from < ends.count; from += kFloatsAtOnce)
        for (int i = from; i < from + kFloatsAtOnce; ++i) {
            const float below = lows[i] - y, above = y - highs[i];
            float away = (below > above ? below : above) - slack;
            away = away > 0.0f ? away : 0.0f;
            const float left = radiusSquared - away * away;
            const float half = std::sqrt(left > 0.0f ? left : 0.0f);
            const float nearHalf = half * widthNear, farHalf = half * widthFar;
            const float a = nearAt - nearHalf, b = farAt - farHalf, c = nearAt + nearHalf,
                        d = farAt + farHalf;
            float first = (a < b ? a : b) - margin, last = (c > d ? c : d) + margin + 1.0f;
            first = first > 0.0f ? first : 0.0f;
            first = first < all ? first : all;
            last = last > 0.0f ? last : 0.0f;
            last = last < all ? last : all;
            // Conversions to int round towards 0, which for what is not negative is down.
            ends.first[i] = static_cast<int>(first);
            ends.last[i] = left < 0.0f ? 0 : static_cast<int>(last);
        }
}

/// The same for degenerate projections and for numbers beyond floats, where only the extent of a
/// tile tells.
void setEndsTileByTile(const Tiles& tiles, const SliceDisc& disc, RowEnds& ends)
{
    for (int i = 0; i < ends.count; ++i) {
        const double left =
            disc.radiusSquared - square(intervalDistance(tiles.rows.extent(ends.row + i), disc.y));
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

SpanFinder::SpanFinder(const Tiles& tiles, int firstRow, int lastRow, const Reach& reach)
    : tiles_(tiles), reach_(reach)
{
    radiusSquared_ = square(reach.radius * kDistanceMargin) -
                     square(intervalDistance(tiles.distance, -reach.centre.z));
    if (radiusSquared_ < 0.0 || tiles.distance.low > tiles.distance.high) return;
    const double half = std::sqrt(radiusSquared_);
    const auto [first, last] = tiles.rows.metBy(reach.centre.y - half, reach.centre.y + half);
    row_ = std::max(first, firstRow);
    end_ = std::min(last, lastRow);
}

bool SpanFinder::next(RowEnds& ends)
{
    if (row_ >= end_) return false;
    ends.row = row_;
    ends.count = std::min(RowEnds::kMost, end_ - row_);
    row_ += ends.count;
    const SliceDisc disc{reach_.centre.x, reach_.centre.y, radiusSquared_};
    if (tiles_.columns.isOrdered() && fitsFloats(tiles_, disc, ends))
        setEnds(tiles_, disc, ends);
    else
        setEndsTileByTile(tiles_, disc, ends);
    if (reach_.hasCone())
        for (int i = 0; i < ends.count; ++i)
            ConeInRow(tiles_, reach_, ends.row + i).trim(ends.first[i], ends.last[i]);
    return true;
}

void addSpans(const ClusterTiles& all, int slice, int firstRow, int lastRow, int32_t light,
              const Reach& reach, std::vector<LightSpan>& spans)
{
    SpanFinder finder(all[slice], firstRow, lastRow, reach);
    for (RowEnds ends; finder.next(ends);)
        for (int i = 0; i < ends.count; ++i)
            if (ends.first[i] < ends.last[i])
                spans.push_back(
                    {light, static_cast<int16_t>(slice), static_cast<int16_t>(ends.row + i),
                     static_cast<int16_t>(ends.first[i]), static_cast<int16_t>(ends.last[i])});
}

}  // namespace fbrdf

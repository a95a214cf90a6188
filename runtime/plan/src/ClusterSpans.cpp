#include "ClusterSpans.h"

#include "ConeTiles.h"

#include <cmath>

namespace fbrdf {
namespace {

/// What one sphere has in common in all rows of a slice.
struct SliceDisc {
    double x, y, radius, radiusSquared;  ///< of its largest section parallel to the picture
};

/// True where floats have room for what setEnds computes.
bool fitsFloats(const Tiles& tiles, const SliceDisc& disc)
{
    constexpr double kLarge = 1e30, kSmall = 1e-30;
    const TileAxis& columns = tiles.columns;
    return disc.radiusSquared > kSmall && disc.radiusSquared < kLarge &&
           square(std::abs(disc.y) + tiles.rows.farthest) < kLarge &&
           (std::abs(disc.x) + columns.farthest + disc.radius) * columns.mostPer < kLarge;
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
    const auto slack = static_cast<float>(kRounding * (std::abs(disc.y) + tiles.rows.farthest)),
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

/// The same as trimToCone there.
void trimToConeTileByTile(const Tiles& tiles, const Reach& reach, RowEnds& ends)
{
    constexpr double kRounding = 1e-6;
    const double slack = kRounding * (std::abs(reach.apex.x) + std::abs(reach.apex.y) +
                                      std::abs(reach.apex.z) + reach.radius + tiles.distance.high);
    for (int i = 0; i < ends.count; ++i) {
        const DistanceRange<double> bounds =
            coneBounds(reach.apex, reach.radius, reach.axis, reach.cosine, reach.sine,
                       tiles.rows.extent(ends.row + i), tiles.distance, slack);
        const auto isMet = [&](int column) {
            const DistanceRange<double> x = tiles.columns.extent(column);
            return x.low <= bounds.high && x.high >= bounds.low;
        };
        int &first = ends.first[i], &last = ends.last[i];
        if (bounds.low > bounds.high) last = first;
        while (first < last && !isMet(first)) ++first;
        while (first < last && !isMet(last - 1)) --last;
    }
}

}  // namespace

SpanFinder::SpanFinder(const Tiles& tiles, int firstRow, int lastRow, const Reach& reach)
    : tiles_(tiles), reach_(reach)
{
    radiusSquared_ = square(reach.radius * kDistanceMargin) -
                     square(intervalDistance(tiles.distance, -reach.centre.z));
    if (radiusSquared_ < 0.0 || tiles.distance.low > tiles.distance.high) return;
    radius_ = std::sqrt(radiusSquared_);
    const auto [first, last] = tiles.rows.metBy(reach.centre.y - radius_, reach.centre.y + radius_);
    row_ = std::max(first, firstRow);
    end_ = std::min(last, lastRow);
}

bool SpanFinder::next(RowEnds& ends)
{
    if (row_ >= end_) return false;
    ends.row = row_;
    ends.count = std::min(RowEnds::kMost, end_ - row_);
    row_ += ends.count;
    const SliceDisc disc{reach_.centre.x, reach_.centre.y, radius_, radiusSquared_};
    if (tiles_.columns.isOrdered() && fitsFloats(tiles_, disc)) {
        setEnds(tiles_, disc, ends);
        if (reach_.hasCone()) trimToCone(tiles_, reach_, ends);
        return true;
    }
    setEndsTileByTile(tiles_, disc, ends);
    if (reach_.hasCone()) trimToConeTileByTile(tiles_, reach_, ends);
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

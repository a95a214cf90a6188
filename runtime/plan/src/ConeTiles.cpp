// A cone is inside of the planes that touch it, and each of them bounds the x of a row by a linear
// function of the row's y.
#include "ConeTiles.h"

#include <cmath>

namespace fbrdf {
namespace {

/// The x of rows between which a light reaches them.
struct RowBounds {
    float low[RowEnds::kMost], high[RowEnds::kMost];
};

/// coneBounds for the rows of `ends` and up to kFloatsAtOnce - 1 behind them.
RowBounds boundsOf(const Tiles& tiles, const Reach& reach, const RowEnds& ends)
{
    constexpr float kRounding = 2e-6f;  // above that of sums of a few products in float, relative
    constexpr float kBeyond = 1e30f;
    const float* const lows = &tiles.rows.floatLows[static_cast<size_t>(ends.row)];
    const float* const highs = &tiles.rows.floatHighs[static_cast<size_t>(ends.row)];
    const auto nearest = static_cast<float>(tiles.distance.low),
               farthest = static_cast<float>(tiles.distance.high);
    const auto size = static_cast<float>(
        std::abs(reach.apex.x) + std::abs(reach.apex.y) + std::abs(reach.apex.z) + reach.radius +
        tiles.distance.high + tiles.rows.farthest + tiles.columns.farthest);
    const int count = (ends.count + kFloatsAtOnce - 1) / kFloatsAtOnce * kFloatsAtOnce;
    RowBounds bounds;
    for (int i = 0; i < count; ++i) bounds.low[i] = -kBeyond, bounds.high[i] = kBeyond;
    for (const HalfSpace<float>& plane :
         conePlanes(Vec3f(reach.apex), static_cast<float>(reach.radius), Vec3f(reach.axis),
                    static_cast<float>(reach.cosine), static_cast<float>(reach.sine))) {
        const Vec3f& out = plane.outwards;
        if (std::abs(out.x) < kEvenPlane<float>) continue;
        const float perX = 1.0f / out.x, behind = std::max(out.z * nearest, out.z * farthest),
                    at = (plane.offset + behind + kRounding * size) * perX, perY = -out.y * perX;
        if (perX > 0.0f)
            for (int i = 0; i < count; ++i) {
                const float a = perY * lows[i], b = perY * highs[i];
                const float high = at + (a > b ? a : b);
                bounds.high[i] = high < bounds.high[i] ? high : bounds.high[i];
            }
        else
            for (int i = 0; i < count; ++i) {
                const float a = perY * lows[i], b = perY * highs[i];
                const float low = at + (a < b ? a : b);
                bounds.low[i] = low > bounds.low[i] ? low : bounds.low[i];
            }
    }
    return bounds;
}

/// Floats of the ends of rows that become tiles, see TileAxis::metBy.
void shorten(const TileAxis& columns, const RowBounds& bounds, RowEnds& ends)
{
    const auto near = static_cast<float>(columns.lines.x),
               far = static_cast<float>(columns.lines.z),
               perNear = static_cast<float>(columns.perNear),
               perFar = static_cast<float>(columns.perFar),
               all = static_cast<float>(columns.count());
    constexpr auto kMargin = static_cast<float>(kTileMargin);
    for (int from = 0; from < ends.count; from += kFloatsAtOnce)
        for (int i = from; i < from + kFloatsAtOnce; ++i) {
            const float low = bounds.low[i], high = bounds.high[i];
            const float a = (low - near) * perNear, b = (low - far) * perFar,
                        c = (high - near) * perNear, d = (high - far) * perFar;
            const float ab = a < b ? a : b, cd = c < d ? c : d, most = a > b ? a : b,
                        more = c > d ? c : d;
            // The columns of a mirrored projection descend.
            float first = (ab < cd ? ab : cd) - kMargin,
                  last = (most > more ? most : more) + kMargin + 1.0f;
            first = first > 0.0f ? first : 0.0f;
            first = first < all ? first : all;
            last = last > 0.0f && low <= high ? last : 0.0f;
            last = last < all ? last : all;
            const int firstTile = static_cast<int>(first), lastTile = static_cast<int>(last);
            ends.first[i] = firstTile > ends.first[i] ? firstTile : ends.first[i];
            ends.last[i] = lastTile < ends.last[i] ? lastTile : ends.last[i];
        }
}

}  // namespace

void trimToCone(const Tiles& tiles, const Reach& reach, RowEnds& ends)
{
    shorten(tiles.columns, boundsOf(tiles, reach, ends), ends);
}

}  // namespace fbrdf

// ClusterTiles.h - the boxes that the view is cut into, in eye space.
#pragma once
#include "ClusterGeometry.h"
#include "LightReach.h"

#include <fbrdf/plan/LightClusters.h>

#include <utility>
#include <vector>

namespace fbrdf {

// Far above the rounding of the shader's float distances.
constexpr double kDistanceMargin = 1.0 + 1e-5;
// Of a tile: far above the float rounding of the shader's pixel coordinates.
constexpr double kTileMargin = 1e-4;

/// The distances from the eye that a sphere spans.
DistanceRange<double> distanceOf(const Reach& reach);
/// More than that by what comparing it with slices may round.
DistanceRange<double> withSlack(const DistanceRange<double>& distance);

/// So many rows are looked at in a step.
constexpr int kFloatsAtOnce = 4;

/// The tiles along one axis of a slice.
struct TileAxis {
    glm::dvec4 lines{0.0};                     ///< see tileExtent
    double perNear = 0.0, perFar = 0.0;        ///< 1 / lines.y and 1 / lines.w
    double mostPer = 0.0;                      ///< the larger of both, without its sign
    double farthest = 0.0;                     ///< the largest coordinate of an edge or of lines
    std::vector<double> lows, highs;           ///< extent of each tile
    std::vector<float> floatLows, floatHighs;  ///< the nearest floats, and kFloatsAtOnce zeros

    size_t count() const { return lows.size(); }
    DistanceRange<double> extent(int tile) const
    {
        return {lows[static_cast<size_t>(tile)], highs[static_cast<size_t>(tile)]};
    }
    /// False for degenerate projections: then only a tile's own extent tells.
    bool isOrdered() const { return lines.y * lines.w > 0.0; }
    /// The range [first, last) of tiles that [low, high] meets. margin: as of tileExtent.
    std::pair<int, int> metBy(double low, double high, double margin = kTileMargin) const
    {
        const auto all = static_cast<double>(count());
        if (!isOrdered()) return {0, static_cast<int>(count())};
        const double a = (low - lines.x) * perNear, b = (low - lines.z) * perFar,
                     c = (high - lines.x) * perNear, d = (high - lines.z) * perFar;
        const double first = std::min(std::min(a, b), std::min(c, d)) - margin,
                     last = std::max(std::max(a, b), std::max(c, d)) + margin + 1.0;
        // Conversions to int round towards 0, which for what is not negative is down.
        return {static_cast<int>(std::clamp(first, 0.0, all)),
                static_cast<int>(std::clamp(last, 0.0, all))};
    }
};

/// The tiles of a slice.
struct Tiles {
    /// The slice, and what lights with a radius reach of it; low is above high where there is none.
    DistanceRange<double> distance;
    TileAxis columns, rows;
};

/// Tiles and slices of a view.
class ClusterTiles {
public:
    ClusterTiles() = default;
    /// clusters: whose grid and slices are set. reach: the distances that lights with a radius
    /// reach, at which the outer slices end.
    ClusterTiles(const LightClusters& clusters, const glm::dmat4& projection,
                 const DistanceRange<double>& reach);
    /// The slices [first, last) in which some of a sphere may be.
    std::pair<int, int> slicesOf(const Reach& reach) const;
    const Tiles& operator[](int slice) const { return slices_[static_cast<size_t>(slice)]; }

private:
    std::vector<Tiles> slices_;
    std::vector<double> lows_, highs_;  ///< of the slices, widened by the margin
};

/// The slice of a distance from the eye along z.
int sliceOf(const LightClusters& clusters, double distance);

}  // namespace fbrdf

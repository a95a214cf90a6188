// Spans of tiles against every tile by itself, in double.
#include "ClusterScenes.h"

#include "ClusterGrid.h"
#include "ClusterSpans.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fbrdf {
namespace {

/// The distance of a point from a box whose sides are widened by a share of a tile.
double distanceFrom(const Tiles& tiles, int row, int column, const Vec3d& point, double share)
{
    const auto along = [share](const DistanceRange<double>& extent, double x) {
        const double more = share * (extent.high - extent.low);
        return intervalDistance({extent.low - more, extent.high + more}, x);
    };
    return glm::length(Vec3d(along(tiles.columns.extent(column), point.x),
                             along(tiles.rows.extent(row), point.y),
                             intervalDistance(tiles.distance, -point.z)));
}

struct SpanCounts {
    size_t listed = 0, lost = 0, idle = 0;
};

/// Compares the spans of spheres in all tiles of a view that is cut for them. scale: of the scene.
SpanCounts countsOf(const glm::dmat4& projection, double scale)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Reach> spheres;
    ReachSums sums;
    for (int i = 0; i < 60; ++i) {
        Reach sphere;
        sphere.centre = scale * Vec3d(12.0 * unit(random) - 6.0, 12.0 * unit(random) - 6.0,
                                      -12.0 * unit(random));
        sphere.radius = scale * std::exp2(6.0 * unit(random) - 4.0);
        sums.add(sphere, projection);
        spheres.push_back(sphere);
    }
    LightClusters clusters;
    clusters.grid = {19, 37,
                     5};  // more rows than are found side by side, and steps that are not whole
    const ClusterTiles all(clusters, projection, setGrid(clusters, rounded(sums)));
    SpanCounts counts;
    for (const Reach& sphere : spheres)
        for (int slice = 0; slice < clusters.grid.slices; ++slice) {
            const Tiles& tiles = all[slice];
            std::vector<LightSpan> spans;
            addSpans(all, slice, 0, clusters.grid.rows, 7, sphere, spans);
            std::vector<char> listed(
                static_cast<size_t>(clusters.grid.rows * clusters.grid.columns));
            for (const LightSpan& span : spans)
                for (int column = span.first; column < span.last; ++column)
                    listed[static_cast<size_t>(span.row * clusters.grid.columns + column)] = 1;
            for (int row = 0; row < clusters.grid.rows; ++row)
                for (int column = 0; column < clusters.grid.columns; ++column) {
                    const bool isListed =
                        listed[static_cast<size_t>(row * clusters.grid.columns + column)] != 0;
                    counts.listed += isListed ? 1 : 0;
                    constexpr double kNearly = 1e-3;  // ten times the margin of tiles
                    if (!isListed &&
                        distanceFrom(tiles, row, column, sphere.centre, 0.0) <= sphere.radius)
                        ++counts.lost;
                    if (isListed && distanceFrom(tiles, row, column, sphere.centre, kNearly) >
                                        sphere.radius * (1.0 + kNearly))
                        ++counts.idle;
                }
        }
    return counts;
}

TEST(ClusterSpans, AreTheTilesThatASphereMeets)
{
    for (const glm::dmat4& projection :
         {perspective(), parallel(), mirrored(true), mirrored(false), offCentre()}) {
        const SpanCounts counts = countsOf(projection, 1.0);
        EXPECT_GT(counts.listed, 1000u);
        EXPECT_EQ(counts.lost, 0u);
        EXPECT_EQ(counts.idle, 0u);
    }
}

// Floats end at 3e38, and squares of distances sooner.
TEST(ClusterSpans, AreThereForScenesOfAnySize)
{
    for (const double scale : {1e-20, 1e-10, 1e10, 1e20}) {
        const SpanCounts counts = countsOf(perspective(), scale);
        EXPECT_EQ(counts.lost, 0u) << scale;
        EXPECT_TRUE(scale < 1.0 || counts.listed > 1000u) << scale << " " << counts.listed;
    }
}

}  // namespace
}  // namespace fbrdf

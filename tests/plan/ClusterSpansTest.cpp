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

/// By row and column, 1 where a slice has the light in the list of a tile.
std::vector<char> listedIn(const ClusterTiles& all, int slice, const LightClusters& clusters,
                           const Reach& reach)
{
    std::vector<LightSpan> spans;
    addSpans(all, slice, 0, clusters.grid.rows, 7, reach, spans);
    std::vector<char> listed(static_cast<size_t>(clusters.grid.rows * clusters.grid.columns));
    for (const LightSpan& span : spans)
        for (int column = span.first; column < span.last; ++column)
            listed[static_cast<size_t>(span.row * clusters.grid.columns + column)] = 1;
    return listed;
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
            const std::vector<char> listed = listedIn(all, slice, clusters, sphere);
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

/// Tiles in all slices of a view for cones of one angle.
struct ConeCounts {
    size_t listed = 0, boxes = 0;  ///< tiles; those of them that one plane does not rule out
    size_t inside = 0, lost = 0;   ///< points in cones; those in tiles that were not listed
};

Reach coneOf(const Vec3d& apex, const Vec3d& axis, double radius, double angle)
{
    Reach cone;
    cone.centre = cone.apex = apex;
    cone.axis = glm::normalize(axis);
    cone.radius = radius;
    cone.cosine = std::cos(angle);
    cone.sine = std::sin(angle);
    return cone;
}

/// Rules a box out by the plane around a cone of up to 90 degrees that is nearest to its centre:
/// the function cosine x (distance from the axis) - sine x (way along it) is above 0 outside, and
/// at least the linear function of the same value and gradient at the centre.
bool missesBox(const Vec3d& toCentre, const Vec3d& half, const Vec3d& axis, double cosine,
               double sine)
{
    const double along = glm::dot(toCentre, axis);
    const Vec3d across = toCentre - along * axis;
    const double distance = glm::length(across);
    const Vec3d outwards = cosine / std::max(distance, 1e-30) * across - sine * axis;
    return cosine * distance - sine * along > glm::dot(glm::abs(outwards), half);
}

/// Looks at points of each tile that a cone's sphere meets.
void countTiles(const Tiles& tiles, const std::vector<char>& listed, const Reach& cone,
                std::mt19937& random, ConeCounts& counts)
{
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto columns = static_cast<int>(tiles.columns.count());
    for (int tile = 0; tile < static_cast<int>(listed.size()); ++tile) {
        const DistanceRange<double> x = tiles.columns.extent(tile % columns),
                                    y = tiles.rows.extent(tile / columns), z = tiles.distance;
        const Vec3d low(x.low, y.low, -z.high),
            size(x.high - x.low, y.high - y.low, z.high - z.low);
        const bool isListed = listed[static_cast<size_t>(tile)] != 0;
        counts.listed += isListed ? 1 : 0;
        if (distanceFrom(tiles, tile / columns, tile % columns, cone.centre, 0.0) > cone.radius)
            continue;
        counts.boxes +=
            missesBox(low + 0.5 * size - cone.apex, 0.5 * size, cone.axis, cone.cosine, cone.sine)
                ? 0
                : 1;
        for (int k = 0; k < 4; ++k) {
            const Vec3d p =
                low + size * Vec3d(unit(random), unit(random), unit(random)) - cone.apex;
            if (glm::length(p) > cone.radius ||
                glm::dot(p, cone.axis) < cone.cosine * glm::length(p))
                continue;
            ++counts.inside;
            counts.lost += isListed ? 0 : 1;
        }
    }
}

/// spanAngle: of the cones whose spans are found, where they are not those that points are in.
ConeCounts conesIn(const glm::dmat4& projection, double scale, double angle, double spanAngle)
{
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    LightClusters clusters;
    clusters.grid = {23, 18, 4};
    ReachSums sums;
    sums.add(coneOf({0.0, 0.0, -6.0 * scale}, {1.0, 0.0, 0.0}, 5.0 * scale, angle), projection);
    const ClusterTiles all(clusters, projection, setGrid(clusters, rounded(sums)));
    ConeCounts counts;
    for (int i = 0; i < 60; ++i) {
        const Vec3d apex(8.0 * unit(random) - 4.0, 8.0 * unit(random) - 4.0, -12.0 * unit(random));
        // The axes of the eye and what is next to them, too, where divisors are near 0.
        Vec3d axis(0.0);
        axis[i % 3] = i % 2 ? -1.0 : 1.0;
        if (i >= 12) axis = Vec3d(unit(random), unit(random), unit(random)) - 0.5;
        if (i < 6) axis += 1e-7 * (Vec3d(unit(random), unit(random), unit(random)) - 0.5);
        const double radius = scale * (0.5 + 3.0 * unit(random));
        const Reach cone = coneOf(scale * apex, axis, radius, angle),
                    asked = coneOf(scale * apex, axis, radius, spanAngle);
        for (int slice = 0; slice < clusters.grid.slices; ++slice) {
            const std::vector<char> listed = listedIn(all, slice, clusters, asked);
            countTiles(all[slice], listed, cone, random, counts);
        }
    }
    return counts;
}

// Eight planes around a cone are hardly looser than the one that is best for each tile.
TEST(ClusterSpans, OfConesLoseNoPointAndFewTiles)
{
    for (const glm::dmat4& projection :
         {perspective(), parallel(), mirrored(true), mirrored(false), offCentre()})
        for (const double angle : {0.05, 0.4, 1.0, 1.5, 0.5 * kPi}) {
            const ConeCounts counts = conesIn(projection, 1.0, angle, angle);
            EXPECT_EQ(counts.lost, 0u) << angle;
            EXPECT_GT(counts.inside, angle > 0.1 ? 100u : 0u) << angle;
            EXPECT_LT(double(counts.listed), 1.25 * double(counts.boxes)) << angle;
        }
}

TEST(ClusterSpans, OfConesAreThereForAnyAngleAndSize)
{
    for (const double angle : {1e-4, 0.5 * kPi + 1e-6, 2.0, 2.9})
        EXPECT_EQ(conesIn(perspective(), 1.0, angle, angle).lost, 0u) << angle;
    for (const double scale : {1e-20, 1e-10, 1e10, 1e20})
        EXPECT_EQ(conesIn(perspective(), scale, 1.0, 1.0).lost, 0u) << scale;
}

TEST(ClusterSpans, OfConesThatAreTooNarrowLosePoints)
{
    EXPECT_GT(conesIn(perspective(), 1.0, 1.0, 0.9).lost, 0u);
}

}  // namespace
}  // namespace fbrdf

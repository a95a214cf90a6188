#include "StrongestLights.h"

#include <algorithm>

namespace fbrdf {
namespace {

/// The part of eye space of one cluster; z: the distance from the eye.
struct ClusterBox {
    DistanceRange<double> x, y, z;
};

/// An upper bound of the irradiance that a light causes in a box, as strongestIrradiance but
/// without the cone.
double strongestIn(const LightVectors& light, const ClusterBox& box)
{
    const double mean = glm::dot(Vec3d(light[1]), Vec3d(1.0)) / 3.0;
    if (light[1].w == 0.0f) return mean;
    const Vec3d at(light[0]);
    const double d2 = square(intervalDistance(box.x, at.x)) +
                      square(intervalDistance(box.y, at.y)) +
                      square(intervalDistance(box.z, -at.z));
    return mean * falloff(d2, isUnlimited(light) ? 0.0 : influenceRadius(light));
}

void shorten(LightClusters& clusters, size_t cluster, const ClusterBox& box, int most)
{
    int32_t* const list = &clusters.lists[2 * cluster];
    if (list[1] <= most) return;
    std::vector<std::pair<double, int32_t>> ranked;
    const auto first = clusters.indices.begin() + list[0];
    for (auto i = first; i != first + list[1]; ++i)
        ranked.emplace_back(-strongestIn(clusters.lights[static_cast<size_t>(*i)], box), *i);
    std::nth_element(ranked.begin(), ranked.begin() + most, ranked.end());
    std::transform(ranked.begin(), ranked.begin() + most, first,
                   [](const auto& one) { return one.second; });
    std::sort(first, first + most);
    clusters.dropped = std::max(clusters.dropped, list[1] - most);
    list[1] = most;
}

}  // namespace

void keepStrongest(LightClusters& clusters, const ClusterTiles& tiles, int most)
{
    const ClusterGrid& grid = clusters.grid;
    size_t cluster = 0;
    for (int slice = 0; slice < grid.slices; ++slice)
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column)
                shorten(clusters, cluster++,
                        {tiles[slice].columns.extent(column), tiles[slice].rows.extent(row),
                         tiles[slice].distance},
                        most);
}

}  // namespace fbrdf

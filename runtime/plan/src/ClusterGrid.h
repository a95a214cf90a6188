// ClusterGrid.h - how finely the view is cut for the lights that are seen.
#pragma once
#include "ClusterGeometry.h"
#include "LightReach.h"

#include <fbrdf/plan/LightClusters.h>

#include <limits>

namespace fbrdf {

/// What the grid depends on, added up over lights with a radius.
struct ReachSums {
    DistanceRange<double> distance{std::numeric_limits<double>::max(), 0.0};  ///< from the eye
    double radius = 0.0;                                                      ///< sum of the radii
    glm::dvec2 projected{0.0};  ///< and of the radii in normalised device coordinates
    int count = 0;

    void add(const Reach& reach, const glm::dmat4& projection);
    void add(const ReachSums& other);
    bool operator==(const ReachSums& other) const;
};

/// The means, rounded so that a grid outlasts small movements of lights: radii to 16ths of an
/// octave, distances outwards to 64ths of the mean radius. {} where there are no lights.
ReachSums rounded(const ReachSums& sums);

/// Sets slices, and the numbers of tiles and slices that the caller left at 0. Returns the
/// distances from the eye that are cut into slices. sums: as rounded() gives them.
DistanceRange<double> setGrid(LightClusters& clusters, const ReachSums& sums);

}  // namespace fbrdf

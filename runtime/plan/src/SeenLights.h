// SeenLights.h - which of the lights can be seen, and which of these have changed since the lists
// were made. Threads share the work where there are many lights; the result does not depend on
// that.
#pragma once
#include "ClusterGrid.h"

#include <fbrdf/base/Workers.h>

#include <vector>

namespace fbrdf {

/// What is remembered of the lights that were given, by place.
struct KnownLights {
    std::vector<int32_t> slots;  ///< index into LightClusters::lights; -1: not seen
    std::vector<Reach> reaches;  ///< of those that are seen and have a radius
};

/// What happened to a light since the lists were made. One that is not seen, before or now, has not
/// changed.
struct LightChange {
    int32_t place = 0;
    bool isSeen = false;  ///< now
    Reach reach = {};     ///< now; of a light that is seen and has a radius
};

/// Looks at all lights as if for the first time: the slots of those that are seen become 0.
/// Returns the sums over these.
ReachSums lookAfresh(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                     KnownLights& known, Workers& workers);

/// The lights that have changed, by place, and the sums over all that are seen now.
struct Comparison {
    std::vector<std::vector<LightChange>> changes;  ///< in blocks
    ReachSums sums;
    size_t count() const;  ///< of changes
};
/// known: of as many lights, seen by the same projection.
Comparison compareLights(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                         const LightClusters& clusters, const KnownLights& known, Workers& workers);

/// True where more than a few lights of a sample differ from what the clusters have.
bool manyHaveChanged(const std::vector<LightVectors>& lights, const LightClusters& clusters);

}  // namespace fbrdf

// StrongestLights.h - a limit for the length of lists.
#pragma once
#include "ClusterTiles.h"

namespace fbrdf {

/// Shortens every list to the `most` lights that can be the strongest in its cluster, which stay
/// ascending, and sets clusters.dropped.
void keepStrongest(LightClusters& clusters, const ClusterTiles& tiles, int most);

}  // namespace fbrdf

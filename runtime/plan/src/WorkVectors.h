// WorkVectors.h - writes down what a GPU makes lists from (ClusterWork.h).
#pragma once
#include "ClusterTiles.h"

#include <fbrdf/base/Workers.h>
#include <fbrdf/plan/ClusterWork.h>

namespace fbrdf {

/// reaches: by place, of lights with a radius.
void setWork(const LightClusters& clusters, const ClusterTiles& tiles,
             const std::vector<Reach>& reaches, Workers& workers, ClusterWork& work);

}  // namespace fbrdf

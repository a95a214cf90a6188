// ClusterWork.h - what a program on the GPU makes the lists of LightClusters.h from. Pure.
#pragma once
#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace fbrdf {

struct ClusterWork {
    /// For each slice: (near, far, 0, 0), the distances from the eye that it spans, and the edges
    /// of its columns and of its rows (tileExtent). Then for each of
    /// LightClusters::lights: (centre, radius) of a sphere around all that it reaches, (apex,
    /// cosine) and (unit axis, sine) of a cone that it stays in; a cosine of -1: there is none.
    /// Lights without a radius have zeros.
    std::vector<glm::vec4> vectors;
    /// Room for so many indices is enough, those of one list of all lights included.
    size_t mostEntries = 0;
    float tileMargin = 0.0f;  ///< of a tile, by which tiles are widened: above float rounding
};
constexpr int kVectorsPerSlice = 3, kVectorsPerReach = 3;

}  // namespace fbrdf

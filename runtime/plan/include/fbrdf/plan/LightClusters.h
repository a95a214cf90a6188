// LightClusters.h - for every part of the view the lights that reach it: Olsson, Billeter,
// Assarsson 2012, "Clustered Deferred and Forward Shading". Pure; a renderer uploads the lists.
//
// The view is cut into columns x rows tiles of pixels and into slices along the distance z from the
// eye (-z of eye space), which grow exponentially: slice = floor(log2(z) x sliceScale + sliceBias),
// clamped. A cluster holds a light when the box around it in eye space meets the light's sphere of
// influence. Twin: fbrdfLightList in clusters.glsl.
#pragma once
#include <fbrdf/plan/LightVectors.h>

#include <cstdint>
#include <vector>

namespace fbrdf {

struct ClusterGrid {
    int columns = 16, rows = 16, slices = 24;  ///< >= 1
    int count() const { return columns * rows * slices; }
};

struct LightClusters {
    ClusterGrid grid;
    float sliceScale = 0.0f, sliceBias = 0.0f;
    /// Lights, those without a radius first: they reach every cluster and are in no list.
    std::vector<LightVectors> lights;
    int everywhere = 0;           ///< how many those are
    std::vector<int32_t> places;  ///< of each of them among the lights that were given
    /// First index and number of indices of each cluster; columns fastest, then rows, then slices.
    std::vector<int32_t> lists;
    std::vector<int32_t> indices;  ///< into lights, ascending in each list
    int longest = 0;               ///< of the lists, with the lights that reach everywhere
};

/// lights: in eye space. projection: perspective or parallel, not sheared in x by y or back.
LightClusters lightClusters(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                            const ClusterGrid& grid = {});

/// Pixels x, y, width, height; empty where width or height is 0.
struct PixelRect {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Contains every pixel that the light can reach; the whole target for a light without a radius, or
/// one that may reach behind the eye.
PixelRect pixelBounds(const LightVectors& light, const glm::dmat4& projection, int width,
                      int height);

}  // namespace fbrdf

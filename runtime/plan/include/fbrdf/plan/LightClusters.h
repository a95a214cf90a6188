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

/// 0: as the lights need, tiles of a quarter of their mean radius and slices of two thirds, at most
/// 32 x 32 x 24.
struct ClusterGrid {
    int columns = 0, rows = 0, slices = 0;
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
    int dropped = 0;               ///< from the list that lost most
};

/// lights: in eye space. projection: perspective or parallel, not sheared in x by y or back.
/// mostPerList: a list holds so many, those that can be the strongest in its cluster; then lights
/// without a radius stand in lists too. 0: no limit.
LightClusters lightClusters(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                            const ClusterGrid& grid = {}, int mostPerList = 0);

/// The list of a point: place in the picture in [-1, 1], distance from the eye along z. Twin:
/// fbrdfLightList in clusters.glsl.
struct LightList {
    int first = 0, count = 0;  ///< in `indices`; beside the lights that reach everywhere
};
LightList listAt(const LightClusters& clusters, const glm::dvec2& ndc, double distance);

/// Pixels x, y, width, height; empty where width or height is 0.
struct PixelRect {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Contains every pixel that the light can reach; the whole target for a light without a radius, or
/// one that may reach behind the eye.
PixelRect pixelBounds(const LightVectors& light, const glm::dmat4& projection, int width,
                      int height);

PixelRect enclosing(const PixelRect& a, const PixelRect& b);  ///< an empty one adds nothing

/// An order in which rectangles near each other follow each other, so that batches of them stay
/// small; sides below 2^16. Indices into rects.
std::vector<int> neighboursTogether(const std::vector<PixelRect>& rects);

}  // namespace fbrdf

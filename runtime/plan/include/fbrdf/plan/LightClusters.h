// LightClusters.h - for every part of the view the lights that reach it: Olsson, Billeter,
// Assarsson 2012, "Clustered Deferred and Forward Shading". Pure; a renderer uploads the lists.
//
// The view is cut into columns x rows tiles of pixels and into slices along the distance z from the
// eye (-z of eye space), which grow exponentially: slice = floor(log2(z) x sliceScale + sliceBias),
// clamped. A cluster lists a light when the box around the cluster in eye space meets the light's
// sphere of influence and, of a spot, its cone. Twin: fbrdfLightList in clusters.glsl.
#pragma once
#include <fbrdf/plan/ClusterWork.h>
#include <fbrdf/plan/LightVectors.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace fbrdf {

/// A number of 0 is chosen from the lights: tiles of a quarter of their mean radius and slices of
/// two thirds of it, at most 96 x 96 x 24 and 32,768 in all.
struct ClusterGrid {
    int columns = 0, rows = 0, slices = 0;
    int count() const { return columns * rows * slices; }
    bool operator==(const ClusterGrid& other) const
    {
        return columns == other.columns && rows == other.rows && slices == other.slices;
    }
};

struct LightClusters {
    ClusterGrid grid;
    float sliceScale = 0.0f, sliceBias = 0.0f;
    /// The lights that can be seen, in any order. Those without a radius come first: they reach
    /// every cluster and are in no list.
    std::vector<LightVectors> lights;
    int everywhere = 0;           ///< number of lights without a radius
    std::vector<int32_t> places;  ///< index of each of `lights` among the lights that were given
    /// First index and number of indices of each cluster; columns fastest, then rows, then slices.
    std::vector<int32_t> lists;
    /// Into lights, by ascending place in each list. Some may be in no list.
    std::vector<int32_t> indices;
    int longest = 0;  ///< length of the longest list, the lights that reach everywhere included
    int dropped = 0;  ///< lights missing from the list that lost most
};

/// Makes lists frame after frame, in memory that it keeps. Where the projection stays and few
/// lights have moved, only these are taken out of lists and put into others; what is in each list
/// is the same as if all were made anew. Threads of its own share the work where there are many
/// lights; the lists do not depend on their number. One thread may use it at a time.
class ClusterBuilder {
public:
    ClusterBuilder();
    ~ClusterBuilder();
    ClusterBuilder(ClusterBuilder&&) noexcept;
    ClusterBuilder& operator=(ClusterBuilder&&) noexcept;

    /// lights: in eye space. projection: perspective or parallel, without a shear between x and y.
    /// mostPerList: the limit of each list, which keeps the lights that can be the strongest in its
    /// cluster; lights without a radius then stand in lists too. 0: no limit. Returns false where
    /// the last call has made the same clusters; lights that are not seen do not matter. Throws
    /// Error(usage) for a grid of more than 32767 on a side, and for lists of more than 2^31 - 1
    /// lights together.
    bool update(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                const ClusterGrid& grid = {}, int mostPerList = 0);
    /// Sets everything but the lists, which are left empty for a GPU to make from work(); `longest`
    /// is then the number of all lights that are seen. Returns false where the last call was one of
    /// these and nothing has changed. Throws Error(usage) for a grid as above.
    bool updateWork(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                    const ClusterGrid& grid = {});
    const LightClusters& clusters() const { return clusters_; }
    const ClusterWork& work() const;
    /// True where the last update changed lists instead of making them anew.
    bool wereEdited() const { return wereEdited_; }

    struct Scratch;

private:
    struct Asked;
    bool update(const std::vector<LightVectors>& lights, const Asked& asked);

    LightClusters clusters_;
    std::unique_ptr<Scratch> scratch_;
    bool wereEdited_ = false;
};

/// The clusters of a ClusterBuilder, once.
LightClusters lightClusters(const std::vector<LightVectors>& lights, const glm::dmat4& projection,
                            const ClusterGrid& grid = {}, int mostPerList = 0);

/// A range of LightClusters::indices; the lights that reach everywhere come on top.
struct LightList {
    int first = 0, count = 0;
};
/// The list of a point, given by its place in the picture in [-1, 1] and its distance from the eye
/// along z. Twin: fbrdfLightList in clusters.glsl, which takes the place in pixels.
LightList lightList(const LightClusters& clusters, const glm::dvec2& ndc, double distance);

/// Pixels x, y, width, height; empty where width or height is 0.
struct PixelRect {
    int x = 0, y = 0, width = 0, height = 0;
};

/// A rectangle that contains every pixel that the light can reach: the whole target for a light
/// without a radius, or one that may reach behind the eye.
PixelRect pixelBounds(const LightVectors& light, const glm::dmat4& projection, int width,
                      int height);

PixelRect enclosing(const PixelRect& a, const PixelRect& b);  ///< an empty one adds nothing

/// Indices into rects, in an order in which neighbours follow each other, so that batches of them
/// stay small. Expects sides below 2^16.
std::vector<int> neighboursTogether(const std::vector<PixelRect>& rects);

}  // namespace fbrdf

// PathTracer.h - pictures with shadows and with light that goes from surface to surface, by Monte
// Carlo integration of the rendering equation (Kajiya 1986, Eq. 1) in double.
//
// Without bounces the mean of many samples is renderReference (CpuRenderer.h) with shadows: what is
// shaded, and what lights send, is the same. So lights of the scene never block each other, the
// camera does not see them, and the back of a surface is black.
#pragma once
#include <fbrdf/brdf/LobeTable.h>
#include <fbrdf/scene/CpuRenderer.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace fbrdf::truth {

/// How area lights and environments are found. All have the same mean; only `combined` is good at
/// both small lights and sharp highlights.
enum class LightSearch { combined, byLights, byMaterials };

struct PathOptions {
    scene::PictureOptions picture = {};
    int bounces = 8;  ///< between surfaces, >= 0; 0: only light that comes straight from its source
    /// false, without bounces alone: nothing is in the way but what scene.shadow says, and the
    /// ground has its reflectedSky. The mean of many samples is renderReference, also of
    /// environments.
    bool shadows = true;
    bool spread = true;  ///< samples over the pixel; false: all at its centre, as renderReference
    uint64_t seed = 0;   ///< another one gives another picture of the same mean
    LightSearch search = LightSearch::combined;
};

struct PathPicture {
    /// The mean of all samples; alpha is the share of them that meet a surface, and the others
    /// count as black.
    scene::Image image;
    /// The standard error of each pixel's mean, estimated as though its samples were independent.
    /// They are spread evenly, so it is about twice too large where paths are short. 0 at first.
    std::vector<Vec3f> error;
};

/// Adds up samples of one scene, which must outlive it. Its pictures do not depend on the number of
/// threads, nor on how samples are divided among calls.
class PathTracer {
public:
    /// lobes: for each of scene.brdfs what directions are drawn by (LobeSampling.h), or an empty
    /// table to draw them by the cosine. It decides about noise alone. Lights that are not valid
    /// light nothing.
    PathTracer(const scene::Scene& scene, std::vector<LobeTable> lobes, const PathOptions& options);
    ~PathTracer();

    /// Traces so many further paths through each pixel, >= 0. A sample that addRows() left
    /// incomplete is completed, and counts as one of them.
    void add(int samples);
    /// Traces a path through each pixel of up to so many further rows, > 0, downwards; at most to
    /// the end of the picture. Whoever has to answer meanwhile adds a sample bit by bit.
    void addRows(int count);
    int samples() const;  ///< that are complete
    PathPicture picture() const;

private:
    class State;
    std::unique_ptr<State> state_;
};

/// The standard error of pixels that are covered, relative to their radiance: roots of mean
/// squares, over pixels and channels. 0 for a black picture.
double noiseOf(const PathPicture& picture);

}  // namespace fbrdf::truth

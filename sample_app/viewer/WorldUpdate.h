// WorldUpdate.h - brings the world of a window, and what of it is on the GPU, in line with the
// document.
#pragma once
#include "GlScene.h"
#include "ToneMapper.h"

namespace fbrdf::viewer {

class WorldUpdate {
public:
    /// The world, and what was uploaded of it, are those of the document. All must outlive this.
    WorldUpdate(World& world, GlScene& scene, ToneMapper& toneMapper, scene::Document document);

    /// Takes over what has changed of the document, but for materials (MaterialEditor). Where a
    /// file cannot be read it throws what reading it throws, and the document has the one that is
    /// shown again.
    void follow(scene::Document& document);

    /// Grows with each change of the picture.
    int revision() const { return revision_; }
    void countChange() { ++revision_; }

private:
    void followMesh(const scene::Document& document);
    void followLights(const scene::Document& document);
    void followEnvironment(const scene::Document& document);
    void followStyle(const scene::Document& document);

    World& world_;
    GlScene& scene_;
    ToneMapper& toneMapper_;
    scene::Document shown_;  ///< what the world is in line with
    int revision_ = 0;
};

}  // namespace fbrdf::viewer

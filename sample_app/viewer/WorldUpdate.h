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

    /// Reads a picture (panoramaOf), so that follow() finds it read. False where it is no panorama.
    bool readEnvironment(const std::string& path);

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
    scene::Document shown_;                  ///< what the world is in line with
    std::optional<scene::LightSet> placed_;  ///< lights before they orbit; none: to be made anew
    /// What readEnvironment() has read last, and its path.
    std::optional<scene::EnvironmentLight> read_;
    std::string readPath_;
    int revision_ = 0;
};

}  // namespace fbrdf::viewer

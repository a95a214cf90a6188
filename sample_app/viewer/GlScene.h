// GlScene.h - a world uploaded to the current GL context and drawn with the runtime.
#pragma once
#include "FrameTimer.h"
#include "GroundPass.h"
#include "PassList.h"
#include "ShadowMaps.h"
#include "World.h"

#include <fbrdf/gl/Renderer.h>

namespace fbrdf::viewer {

/// What is drawn. `instances` use the one mesh; their materials are indices into the world's.
struct GlRequest {
    Technique technique = Technique::single;
    std::vector<scene::Instance> instances;
    gl::View view;
    const scene::LightSet* lights = nullptr;
    const scene::Ground* ground = nullptr;  ///< null: none
    int sample = 0;  ///< of the pixels; the view is moved already, shadows depend on it
    gl::GpuMaterial* only =
        nullptr;   ///< all instances are made of it; null: of materials by number
    int step = 1;  ///< one pixel in step x step is drawn: shadows may be as coarse
};

class GlScene {
public:
    /// Uploads the mesh and every material (fitting what needs it). Belongs to the context that is
    /// current now. Problems that a draw survives are printed to stderr, each once.
    GlScene(gl::LoadFunction load, World& world, const Options& options);

    const gl::Renderer& renderer() const { return renderer_; }
    /// Of the last draw, those of the ground first.
    const PassList& passes() const { return passes_; }
    void replaceMesh(const World& world);
    /// Takes another material in the place of one, or one more where `index` is their number.
    void setMaterial(size_t index, const Material& material);
    /// Uploads one for GlRequest::only.
    std::shared_ptr<gl::GpuMaterial> uploaded(const Material& material);
    /// Takes the plane of a ground, and what the objects hide of the sky above it.
    void replaceGround(const scene::Ground& ground);
    /// Casts shadows from the next draw on, or none.
    void setShadows(bool shadows, const World& world);
    void setLimits(const scene::DrawLimits& limits) { limits_ = limits; }
    /// Uploads all materials again, with maps of another kind.
    void setUpload(LookUp lookUp, bool precise, World& world);
    /// Directions of the environment to draw; it has to be replaced afterwards.
    void setEnvironmentSamples(int samples);
    /// Takes another environment, or none. What is drawn of it at most are so many lobes, or all
    /// that a material has (0).
    void replaceEnvironment(const scene::EnvironmentLight* light);
    /// Follows rotation and intensity of the environment that is there.
    void turnEnvironment(const scene::EnvironmentLight& light, int lobes);
    /// Goes on with an environment of a window, which comes gradually, for about so long. True
    /// where it has become sharper.
    bool refineEnvironment(double milliseconds);
    /// True while there is more to come.
    bool isRefining() const { return environment_ && !environment_->isFinished(); }
    /// All of it at once; true where something was left.
    bool finishEnvironment();
    /// Counts how often it has become sharper.
    int sharpness() const { return sharpness_; }
    /// Compiles what drawing the world will need.
    void prepare(Technique technique, const World& world);
    /// Draws the ground, where it is seen, and the objects. The stats are those of the objects, but
    /// for draw calls and failures, which are those of all.
    gl::DrawStats draw(const gl::Target& target, const GlRequest& request);

private:
    /// As uploaded: all of a mesh, or what is enough of it for coarse pictures.
    struct Meshes {
        std::shared_ptr<gl::GpuMesh> whole, coarse;
        const gl::GpuMesh* at(int step) const { return step > 1 ? coarse.get() : whole.get(); }
    };
    gl::DrawOptions drawOptions(Technique technique, const scene::LightSet& lights) const;
    gl::Item groundItem(const scene::Ground& ground) const;
    gl::DrawStats drawGround(const gl::Target& target, const GlRequest& request);

    PassList passes_;
    gl::Renderer renderer_;
    gl::MaterialOptions uploaded_;
    gl::LoadFunction load_;
    std::unique_ptr<ShadowMaps> shadowMaps_;  ///< null: no shadows
    std::shared_ptr<gl::GpuHooks> hooks_;     ///< of the shadows
    scene::DrawLimits limits_;
    GroundPass groundPass_;
    std::shared_ptr<gl::GpuEnvironment> environment_;
    gl::EnvironmentLight environmentLight_;
    const bool gradual_;          ///< environments come gradually
    double refinedTexels_ = 0.0;  ///< of the last step
    FrameTimer refineTimer_;
    int sharpness_ = 0;
    Vec3d skyIrradiance_{0.0};  ///< of the environment on an open ground
    std::vector<std::shared_ptr<gl::GpuMaterial>> materials_;
    std::shared_ptr<gl::GpuMaterial> groundMaterial_;
    Meshes mesh_;
    std::shared_ptr<gl::GpuMesh> groundMesh_;
};

}  // namespace fbrdf::viewer

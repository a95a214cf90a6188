// GlScene.h - a world uploaded to the current GL context and drawn with the runtime.
#pragma once
#include "World.h"

#include <fbrdf/gl/Renderer.h>

namespace fbrdf::viewer {

class GlScene {
public:
    /// Uploads the mesh and every material (fitting what needs it). Belongs to the context that is
    /// current now. Problems that a draw survives are printed to stderr, each once.
    /// lobes, samples: as those of EnvironmentLight.
    struct EnvironmentQuality {
        int lobes = 0, samples = 0;
    };
    GlScene(gl::LoadFunction load, World& world, const gl::MaterialOptions& uploaded,
            const EnvironmentQuality& quality);

    const gl::Renderer& renderer() const { return renderer_; }
    void replaceMesh(const scene::Mesh& mesh);
    /// Compiles what drawing will need.
    void prepare(Technique technique, const scene::LightSet& lights);
    /// `instances` use the one mesh; their materials are indices into the world's.
    gl::DrawStats draw(const gl::Target& target, const gl::View& view,
                       const std::vector<scene::Instance>& instances, const scene::LightSet& lights,
                       Technique technique);

private:
    gl::DrawOptions drawOptions(Technique technique, const scene::LightSet& lights) const;

    gl::Renderer renderer_;
    std::shared_ptr<gl::GpuEnvironment> environment_;
    gl::EnvironmentLight environmentLight_;
    std::vector<std::shared_ptr<gl::GpuMaterial>> materials_;
    std::shared_ptr<gl::GpuMesh> mesh_;
};

}  // namespace fbrdf::viewer

#include "bench/Variants.h"

#include "bench/Materials.h"
#include "bench/ShaderPeers.h"

#include <fbrdf/base/Error.h>

#include <memory>

namespace fbrdf::bench {
namespace {

struct Drawn {
    std::shared_ptr<gl::GpuMaterial> material;
    std::shared_ptr<gl::GpuMesh> mesh;
};

Draw drawWithRuntime(const Material& material, const gl::MaterialOptions& uploaded,
                     const gl::DrawOptions& options, const Scene& scene)
{
    const Drawn drawn{scene.renderer.createMaterial(material, uploaded),
                      scene.renderer.createMesh(scene.stage.mesh)};
    scene.renderer.prepare(*drawn.material, options, static_cast<int>(scene.lights.size()));
    return [drawn, options, &scene] {
        const std::vector<gl::Item> items{{drawn.material.get(), drawn.mesh.get()}};
        const gl::DrawStats stats =
            scene.renderer.draw(scene.target, scene.stage.view, items, scene.lights, options);
        if (stats.itemsFailed > 0)
            throw Error(ErrorKind::gl, "runtime", "found an object that cannot be drawn");
    };
}

Variant runtimeVariant(const std::string& form, Technique technique,
                       const gl::MaterialOptions& uploaded = {})
{
    gl::DrawOptions options;
    options.technique = technique;
    const bool isNative = uploaded.lookUp == LookUp::native;
    const std::string name = form +
                             (isNative ? "" : std::string(" ") + lookUpName(uploaded.lookUp)) +
                             (uploaded.precise ? " precise " : " ") + techniqueName(technique);
    return {name, techniqueInfo(technique).description,
            [form, uploaded, options](const Scene& scene) {
                return drawWithRuntime(ggxMaterial(form), uploaded, options, scene);
            }};
}

Variant peerVariant(ShaderPeer peer)
{
    const auto shared = std::make_shared<const ShaderPeer>(std::move(peer));
    return {shared->name, shared->description, [shared](const Scene& scene) {
                const auto drawing = std::make_shared<const PeerDrawing>(
                    scene.gl, *shared, scene.stage, static_cast<int>(scene.lights.size()));
                return [shared, drawing, &scene] { drawing->draw(scene.target, scene.lights); };
            }};
}

}  // namespace

std::vector<Variant> allVariants()
{
    std::vector<Variant> variants;
    for (ShaderPeer& peer : shaderPeers()) variants.push_back(peerVariant(std::move(peer)));
    for (const char* form : {"hdio", "hdpio", "hdpu", "hdsu", "pqp", "pqpr", "io+hdio"})
        for (const Technique technique : allTechniques())
            variants.push_back(runtimeVariant(form, technique));
    for (const LookUp lookUp : {LookUp::parabolic, LookUp::cube})
        variants.push_back(runtimeVariant("pqp", Technique::single, {lookUp}));
    gl::MaterialOptions precise;
    precise.precise = true;
    for (const char* form : {"hdio", "pqp"})
        variants.push_back(runtimeVariant(form, Technique::single, precise));
    return variants;
}

}  // namespace fbrdf::bench

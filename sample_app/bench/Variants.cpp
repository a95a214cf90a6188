#include "bench/Variants.h"

#include "bench/Materials.h"
#include "bench/ShaderCost.h"
#include "bench/ShaderPeers.h"

#include <fbrdf/base/Error.h>

#include <map>
#include <memory>
#include <utility>

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

/// shader: that of a pass with so many lights. bytesOf: of one fetch by the name of its sampler.
template <class BytesOf>
LightCost passCost(const std::string& shader, int lights, const BytesOf& bytesOf)
{
    const ShaderCost cost = costOf(shader, {{"fbrdfLightCount", lights}});
    LightCost result{cost.multiplyAdds(), cost.specials, 0.0};
    for (const auto& [sampler, count] : cost.fetches) result.bytes += count * bytesOf(sampler);
    return result;
}

void add(LightCost& sum, const LightCost& pass, double share)
{
    sum.multiplyAdds += share * pass.multiplyAdds;
    sum.specials += share * pass.specials;
    sum.bytes += share * pass.bytes;
}

/// Of RGB texels that a linear filter mixes.
double bytesOfFetch(const TextureImage& image)
{
    const double texel = image.type == TexelType::float32 ? 12.0 : 6.0;
    if (image.encoding.precise) return texel;
    return texel * (image.size[2] > 1 && image.encoding.lookUp != LookUp::cube ? 8.0 : 4.0);
}

/// The texels of a material as the renderer uploads them; empty for knots in uniforms.
std::vector<TextureImage> imagesOf(const Material& material, const gl::MaterialOptions& options,
                                   const Capabilities& capabilities)
{
    std::vector<TextureImage> images;
    for (size_t k = 0; k < material.tables.size(); ++k) {
        const Table& table = material.tables[k];
        TextureImage image;
        image.encoding = {isLog(table.storage), false};
        const bool native =
            options.lookUp == LookUp::native ||
            !whyNotRecombined(material.form, static_cast<int>(k), table.storage).empty();
        if (!material.form.tables[k].uniform)
            image = native ? textureImage(table, capabilities)
                           : textureImage(recombined(table, {options.lookUp, options.mapSize,
                                                             capabilities.maxTextureSize,
                                                             capabilities.seamlessCubes}),
                                          capabilities);
        image.encoding.precise = options.precise;
        images.push_back(std::move(image));
    }
    return images;
}

LightCost runtimeCost(const Material& material, const gl::MaterialOptions& uploaded,
                      const gl::DrawOptions& options, const Scene& scene)
{
    const Capabilities& capabilities = scene.renderer.capabilities();
    PlanRequest request;
    request.technique = options.technique;
    request.lights = static_cast<int>(scene.lights.size());
    const Plan plan = planPasses(material.form, request, capabilities);
    const auto images = imagesOf(material, uploaded, capabilities);
    std::vector<TableEncoding> encodings;
    for (const TextureImage& image : images) encodings.push_back(image.encoding);
    const auto bytesOf = [&](const std::string& sampler) {
        constexpr double kSurfaceTexel = 16.0;  // RGBA32F, of which one is read
        if (sampler == "fbrdfRead") return kSurfaceTexel;
        return bytesOfFetch(
            images.at(std::stoul(sampler.substr(sampler.find_last_not_of("0123456789") + 1))));
    };
    LightCost sum;
    std::map<std::pair<std::string, int>, LightCost> known;  // most passes are alike
    for (const Pass& pass : plan.passes) {
        const ProgramSpec spec =
            programSpec(pass, maxLightsInUniforms(material.form, capabilities, pass.lobes));
        const std::string text = fragmentSource(material.form, encodings, spec, capabilities.glsl);
        const auto [found, isNew] = known.try_emplace({text, pass.lightCount});
        if (isNew) found->second = passCost(text, pass.lightCount, bytesOf);
        add(sum, found->second, 1.0 / request.lights);
    }
    return sum;
}

LightCost peerCost(const ShaderPeer& peer, const Scene& scene)
{
    const auto bytesOf = [&](const std::string& sampler) {
        for (const PeerMap& map : peer.maps)
            if (map.sampler == sampler) return bytesOfFetch(map.image);
        return 0.0;
    };
    const int lights = static_cast<int>(scene.lights.size()),
              inPass = peer.passPerLight ? 1 : lights;
    const std::string text = peerFragmentSource(peer, inPass);
    LightCost sum;
    add(sum, passCost(text, inPass, bytesOf), 1.0 / inPass);
    if (peer.passPerLight) add(sum, passCost(text, 0, bytesOf), 1.0 / lights);
    return sum;
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
            },
            [form, uploaded, options](const Scene& scene) {
                return runtimeCost(ggxMaterial(form), uploaded, options, scene);
            }};
}

Variant peerVariant(ShaderPeer peer)
{
    const auto shared = std::make_shared<const ShaderPeer>(std::move(peer));
    return {shared->name, shared->description,
            [shared](const Scene& scene) {
                const auto drawing = std::make_shared<const PeerDrawing>(
                    scene.gl, *shared, scene.stage, static_cast<int>(scene.lights.size()));
                return [shared, drawing, &scene] { drawing->draw(scene.target, scene.lights); };
            },
            [shared](const Scene& scene) { return peerCost(*shared, scene); }};
}

}  // namespace

std::vector<Variant> allVariants()
{
    std::vector<Variant> variants;
    for (ShaderPeer& peer : shaderPeers()) variants.push_back(peerVariant(std::move(peer)));
    for (const char* form : {"hdio", "hdpio", "hdpu", "hdsu", "hdau", "pqp", "pqpr", "io+hdio"})
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

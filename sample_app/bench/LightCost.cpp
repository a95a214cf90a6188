#include "bench/LightCost.h"

#include "bench/ShaderCost.h"

#include <fbrdf/shaders/ShaderSource.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace fbrdf::bench {
namespace {

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

/// GLSL ES 1.00 cannot index uniforms by a value that varies: the renderer makes textures of them.
Form drawnForm(Form form, const Capabilities& capabilities)
{
    for (TableSpec& table : form.tables)
        if (capabilities.glsl == 100) table.uniform = false;
    return form;
}

/// Of a surface, one texel of which is read.
double bytesOfTexel(ColourFormat format)
{
    if (format == ColourFormat::rgba8) return 4.0;
    return format == ColourFormat::rgba32f ? 16.0 : 8.0;
}

}  // namespace

UploadedMaterial uploadedMaterial(const Material& material, const gl::MaterialOptions& options,
                                  const Capabilities& capabilities)
{
    UploadedMaterial result{drawnForm(material.form, capabilities), hasSigns(material), {}};
    for (size_t k = 0; k < material.tables.size(); ++k) {
        const fbrdf::Table& table = material.tables[k];
        TextureImage image;
        image.encoding = {isLog(table.storage), false};
        const bool native =
            options.lookUp == LookUp::native ||
            !whyNotRecombined(result.form, static_cast<int>(k), table.storage).empty();
        if (!result.form.tables[k].uniform)
            image = native ? textureImage(table, capabilities)
                           : textureImage(recombined(table, {options.lookUp, options.mapSize,
                                                             capabilities.maxTextureSize,
                                                             capabilities.seamlessCubes}),
                                          capabilities);
        image.encoding.precise = options.precise;
        result.images.push_back(std::move(image));
    }
    return result;
}

LightCost runtimeCost(const UploadedMaterial& material, PlanRequest request,
                      const Capabilities& capabilities)
{
    request.signs = material.signs;
    const Form& form = material.form;
    const Plan plan = planPasses(form, request, capabilities);
    std::vector<TableEncoding> encodings;
    for (const TextureImage& image : material.images) encodings.push_back(image.encoding);
    const auto bytesOf = [&](const std::string& sampler) {
        if (sampler == "fbrdfRead") return bytesOfTexel(plan.surfaces);
        return bytesOfFetch(material.images.at(
            std::stoul(sampler.substr(sampler.find_last_not_of("0123456789") + 1))));
    };
    LightCost sum;
    std::map<std::pair<std::string, int>, LightCost> known;  // most passes are alike
    for (const Pass& pass : plan.passes) {
        const ProgramSpec spec =
            programSpec(pass, maxLightsInUniforms(form, capabilities, pass.lobes));
        const std::string text = fragmentSource(form, encodings, spec, capabilities.glsl);
        const auto [found, isNew] = known.try_emplace({text, pass.lightCount});
        if (isNew) found->second = passCost(text, pass.lightCount, bytesOf);
        add(sum, found->second, 1.0 / request.lights);
    }
    return sum;
}

LightCost peerCost(const ShaderPeer& peer, int lights)
{
    const auto bytesOf = [&](const std::string& sampler) {
        for (const PeerMap& map : peer.maps)
            if (map.sampler == sampler) return bytesOfFetch(map.image);
        return 0.0;
    };
    const int inPass = peer.passPerLight ? 1 : lights;
    const std::string text = peerFragmentSource(peer, inPass);
    LightCost sum;
    add(sum, passCost(text, inPass, bytesOf), 1.0 / inPass);
    if (peer.passPerLight) add(sum, passCost(text, 0, bytesOf), 1.0 / lights);
    return sum;
}

}  // namespace fbrdf::bench

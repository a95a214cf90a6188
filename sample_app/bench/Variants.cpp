#include "bench/Variants.h"

#include "bench/Materials.h"
#include "bench/ShaderPeers.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <sstream>
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

Variant runtimeVariant(const std::string& form, const std::string& word, Technique technique)
{
    gl::DrawOptions options;
    options.technique = technique;
    const gl::MaterialOptions uploaded = materialOptionsFromWord(word);
    return {form + (word.empty() ? " " : " " + word + " ") + techniqueName(technique),
            techniqueInfo(technique).description,
            [form, uploaded, options](const Scene& scene) {
                return drawWithRuntime(benchMaterial(form), uploaded, options, scene);
            },
            [form, uploaded, technique](const Scene& scene) {
                PlanRequest request;
                request.technique = technique;
                request.lights = static_cast<int>(scene.lights.size());
                const Capabilities& capabilities = scene.renderer.capabilities();
                return runtimeCost(uploadedMaterial(benchMaterial(form), uploaded, capabilities),
                                   request, capabilities);
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
            [shared](const Scene& scene) {
                return peerCost(*shared, static_cast<int>(scene.lights.size()));
            }};
}

std::vector<std::string> wordsOf(const std::string& text)
{
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

bool isTechnique(const std::string& word)
{
    const auto& all = allTechniques();
    return std::any_of(all.begin(), all.end(),
                       [&](Technique technique) { return word == techniqueName(technique); });
}

}  // namespace

gl::MaterialOptions materialOptionsFromWord(const std::string& word)
{
    gl::MaterialOptions options;
    options.precise = word == "precise";
    if (!word.empty() && !options.precise) options.lookUp = lookUpFromName(word);
    return options;
}

std::vector<Variant> allVariants()
{
    std::vector<Variant> variants;
    for (ShaderPeer& peer : shaderPeers()) variants.push_back(peerVariant(std::move(peer)));
    for (const std::string& form : allForms())
        for (const Technique technique : allTechniques())
            variants.push_back(runtimeVariant(form, "", technique));
    for (const char* word : {"parabolic", "cube"})
        variants.push_back(runtimeVariant("pqp", word, Technique::single));
    for (const char* form : {"hdio", "hdpio", "hdpu", "pqp"})
        variants.push_back(runtimeVariant(form, "precise", Technique::single));
    return variants;
}

std::vector<Variant> variantsNamed(const std::string& name)
{
    for (Variant& variant : allVariants())
        if (variant.name == name) return {std::move(variant)};
    std::vector<std::string> words = wordsOf(name);
    std::vector<Technique> techniques(allTechniques().begin(), allTechniques().end());
    if (!words.empty() && isTechnique(words.back())) {
        techniques = {techniqueFromName(words.back())};
        words.pop_back();
    }
    if (words.empty() || words.size() > 2)
        throw Error(ErrorKind::usage, "--only",
                    Found("'" + name + "'").expected("a variant such as 'hdio single'"));
    benchMaterial(words[0]);  // throws where there is no such form
    std::vector<Variant> result;
    for (const Technique technique : techniques)
        result.push_back(runtimeVariant(words[0], words.size() > 1 ? words[1] : "", technique));
    return result;
}

}  // namespace fbrdf::bench

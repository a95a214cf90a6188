#include "GlScene.h"

#include <fmt/core.h>

#include <set>

namespace fbrdf::viewer {
namespace {

const char* severityName(gl::Severity severity)
{
    if (severity == gl::Severity::error) return "error";
    return severity == gl::Severity::warning ? "warning" : "note";
}

gl::RendererOptions rendererOptions(gl::LoadFunction load)
{
    gl::RendererOptions options;
    options.load = load;
    options.log = [seen = std::set<std::string>()](gl::Severity severity,
                                                   const std::string& text) mutable {
        if (severity != gl::Severity::note && seen.insert(text).second)
            fmt::print(stderr, "fbrdf-viewer: {}: {}\n", severityName(severity), text);
    };
    return options;
}

}  // namespace

GlScene::GlScene(gl::LoadFunction load, World& world, const gl::MaterialOptions& uploaded,
                 const EnvironmentQuality& quality)
    : renderer_(rendererOptions(load))
{
    if (const auto& light = world.environment) {
        environment_ =
            renderer_.createEnvironment(light->panorama, {0, false, quality.samples > 0});
        environmentLight_ = {
            environment_.get(), gl::environmentRotation(static_cast<float>(light->rotation)),
            Vec3f(static_cast<float>(light->intensity)), quality.lobes, quality.samples};
    }
    for (MaterialSlot& slot : world.materials)
        materials_.push_back(renderer_.createMaterial(slot.material(), uploaded));
    replaceMesh(world.mesh);
}

gl::DrawOptions GlScene::drawOptions(Technique technique, const scene::LightSet& lights) const
{
    gl::DrawOptions options;
    options.technique = technique;
    options.environment = environmentLight_;
    options.areaLights = lights.areaLights;
    return options;
}

void GlScene::replaceMesh(const scene::Mesh& mesh)
{
    mesh_ = renderer_.createMesh(mesh);
}

void GlScene::prepare(Technique technique, const scene::LightSet& lights)
{
    for (const auto& material : materials_)
        renderer_.prepare(*material, drawOptions(technique, lights),
                          static_cast<int>(lights.lights.size()));
}

gl::DrawStats GlScene::draw(const gl::Target& target, const gl::View& view,
                            const std::vector<scene::Instance>& instances,
                            const scene::LightSet& lights, Technique technique)
{
    std::vector<gl::Item> items;
    for (const scene::Instance& instance : instances)
        items.push_back({materials_[static_cast<size_t>(instance.material)].get(), mesh_.get(),
                         instance.model});
    return renderer_.draw(target, view, items, lights.lights, drawOptions(technique, lights));
}

}  // namespace fbrdf::viewer

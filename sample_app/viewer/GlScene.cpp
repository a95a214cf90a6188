#include "GlScene.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace fbrdf::viewer {
namespace {

const scene::Mesh& coarseMeshOf(const World& world)
{
    return world.coarseMesh ? *world.coarseMesh : world.mesh;
}

const char* severityName(gl::Severity severity)
{
    if (severity == gl::Severity::error) return "error";
    return severity == gl::Severity::warning ? "warning" : "note";
}

// Who tries every technique makes hundreds, and a software rasterizer needs half a megabyte for
// each.
constexpr size_t kIdlePrograms = 24;

gl::RendererOptions rendererOptions(gl::LoadFunction load, PassList& passes)
{
    gl::RendererOptions options;
    options.load = load;
    options.passes = passes.watch();
    options.idlePrograms = kIdlePrograms;
    options.log = [seen = std::set<std::string>()](gl::Severity severity,
                                                   const std::string& text) mutable {
        if (severity != gl::Severity::note && seen.insert(text).second)
            fmt::print(stderr, "fbrdf-viewer: {}: {}\n", severityName(severity), text);
    };
    return options;
}

}  // namespace

GlScene::GlScene(gl::LoadFunction load, World& world, const Options& options)
    : passes_(load),
      renderer_(rendererOptions(load, passes_)),
      uploaded_{options.document.lookUp, 0, options.document.precise},
      load_(load),
      limits_(options.document.limits),
      groundPass_(load),
      gradual_(!options.headless && !options.frames),
      refineTimer_(load)
{
    environmentLight_.lobes = options.document.environment.lobes;
    environmentLight_.samples = options.document.environment.samples;
    if (world.environment) replaceEnvironment(&*world.environment);
    for (MaterialSlot& slot : world.materials) setMaterial(materials_.size(), slot.material());
    replaceMesh(world);
    setShadows(options.document.shadows, world);
    if (world.ground) replaceGround(*world.ground);
}

void GlScene::setShadows(bool shadows, const World& world)
{
    hooks_.reset();
    shadowMaps_.reset();
    if (!shadows) return;
    shadowMaps_ = std::make_unique<ShadowMaps>(load_);
    shadowMaps_->setMesh(world.mesh, coarseMeshOf(world));
    hooks_ = renderer_.createHooks(shadowMaps_->hooks());
}

void GlScene::setUpload(LookUp lookUp, bool precise, World& world)
{
    uploaded_.lookUp = lookUp;
    uploaded_.precise = precise;
    groundMaterial_.reset();
    for (size_t i = 0; i < materials_.size(); ++i) setMaterial(i, world.materials[i].material());
    if (world.ground) replaceGround(*world.ground);
}

void GlScene::replaceGround(const scene::Ground& ground)
{
    if (!groundMaterial_)
        groundMaterial_ = renderer_.createMaterial(scene::Ground::material(), uploaded_);
    groundMesh_ = renderer_.createMesh(*ground.object(0).mesh);
    groundPass_.setVisibility(ground.visibility());
}

gl::DrawOptions GlScene::drawOptions(Technique technique, const scene::LightSet& lights) const
{
    gl::DrawOptions options;
    options.technique = technique;
    options.environment = environmentLight_;
    options.areaLights = lights.areaLights;
    options.maxLookups = limits_.lookups;
    options.maxLights = limits_.lights;
    options.lightsPerPass = limits_.lightsPerPass;
    return options;
}

std::shared_ptr<gl::GpuMaterial> GlScene::uploaded(const Material& material)
{
    return renderer_.createMaterial(material, uploaded_);
}

void GlScene::setMaterial(size_t index, const Material& material)
{
    if (index == materials_.size())
        materials_.push_back(uploaded(material));
    else
        materials_[index] = uploaded(material);
}

void GlScene::replaceMesh(const World& world)
{
    mesh_.whole = renderer_.createMesh(world.mesh);
    mesh_.coarse = world.coarseMesh ? renderer_.createMesh(*world.coarseMesh) : mesh_.whole;
    if (shadowMaps_) shadowMaps_->setMesh(world.mesh, coarseMeshOf(world));
}

void GlScene::replaceEnvironment(const scene::EnvironmentLight* light)
{
    environmentLight_.map = nullptr;
    environment_.reset();
    skyIrradiance_ = Vec3d(0.0);
    if (!light) return;
    environment_ = renderer_.createEnvironment(light->panorama,
                                               {0, false, environmentLight_.samples > 0, gradual_});
    environmentLight_.map = environment_.get();
    turnEnvironment(*light, environmentLight_.lobes);
}

void GlScene::setEnvironmentSamples(int samples)
{
    environmentLight_.samples = samples;
}

void GlScene::turnEnvironment(const scene::EnvironmentLight& light, int lobes)
{
    environmentLight_.rotation = gl::environmentRotation(static_cast<float>(light.rotation));
    environmentLight_.intensity = Vec3f(static_cast<float>(light.intensity));
    environmentLight_.lobes = lobes;
    skyIrradiance_ = light.upwardIrradiance();
}

bool GlScene::refineEnvironment(double milliseconds)
{
    if (!isRefining()) return false;
    constexpr double kFirstTexels = 2048.0, kFastest = 0.1;
    refinedTexels_ = std::max(refinedTexels_, kFirstTexels);
    refineTimer_.begin();
    const bool isFinished = renderer_.refine(*environment_, std::llround(refinedTexels_));
    const double taken = std::max(kFastest, refineTimer_.end());
    refinedTexels_ *= std::clamp(milliseconds / taken, 0.5, 2.0);
    sharpness_ += isFinished;
    return isFinished;
}

bool GlScene::finishEnvironment()
{
    constexpr long long kAll = std::numeric_limits<long long>::max() / 2;
    if (!isRefining()) return false;
    const bool isFinished = renderer_.refine(*environment_, kAll);
    sharpness_ += isFinished;
    return isFinished;
}

void GlScene::prepare(Technique technique, const World& world)
{
    gl::DrawOptions options = drawOptions(technique, world.lights);
    const auto count = static_cast<int>(world.lights.lights.size());
    for (const auto& material : materials_)
        renderer_.prepare({material.get(), mesh_.whole.get(), glm::mat4(1.0f), hooks_.get()},
                          options, count);
    if (!world.ground) return;
    options.environment.map = nullptr;
    renderer_.prepare(groundItem(*world.ground), options, count);
}

gl::Item GlScene::groundItem(const scene::Ground& ground) const
{
    return {groundMaterial_.get(), groundMesh_.get(), ground.object(0).model, hooks_.get()};
}

/// The runtime lights the plane, and the pass adds the sky and fades it.
gl::DrawStats GlScene::drawGround(const gl::Target& target, const GlRequest& request)
{
    gl::DrawOptions options = drawOptions(request.technique, *request.lights);
    options.environment.map = nullptr;
    const gl::DrawStats drawn = renderer_.draw(target, request.view, {groundItem(*request.ground)},
                                               request.lights->lights, options);
    groundPass_.draw(target, request.view, *request.ground, skyIrradiance_);
    return drawn;
}

gl::DrawStats GlScene::draw(const gl::Target& target, const GlRequest& request)
{
    const std::vector<Light>& lights = request.lights->lights;
    passes_.begin();
    if (shadowMaps_)
        shadowMaps_->draw(
            request.instances,
            shadowedLights(lights, scene::boundsOf(request.instances), request.sample),
            request.view, request.step);
    gl::DrawStats ground;
    if (request.ground && request.ground->isSeenFrom(request.view))
        ground = drawGround(target, request);
    std::vector<gl::Item> items;
    for (const scene::Instance& instance : request.instances)
        items.push_back(
            {request.only ? request.only : materials_[static_cast<size_t>(instance.material)].get(),
             mesh_.at(request.step), instance.model, hooks_.get()});
    gl::DrawStats drawn = renderer_.draw(target, request.view, items, lights,
                                         drawOptions(request.technique, *request.lights));
    drawn.drawCalls += ground.drawCalls;
    drawn.itemsFailed += ground.itemsFailed;
    return drawn;
}

}  // namespace fbrdf::viewer

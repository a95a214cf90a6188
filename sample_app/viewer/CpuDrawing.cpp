#include "CpuDrawing.h"

#include <algorithm>
#include <chrono>

namespace fbrdf::viewer {
namespace {

// Enough to see what a picture will be.
constexpr int kDefaultSamples = 64;

scene::Scene sceneOf(World& world, const CpuRequest& request)
{
    scene::Scene scene;
    scene.instances = request.instances;
    for (MaterialSlot& slot : world.materials) scene.brdfs.push_back(slot.truth());
    scene.lights = world.lights.lights;
    scene.areaLights = world.lights.areaLights;
    if (world.environment) scene.environment = &*world.environment;
    scene.view = request.view;
    return scene;
}

truth::PathOptions pathOptionsOf(const Options& options, const CpuRequest& request)
{
    truth::PathOptions path;
    path.picture = {request.width, request.height};
    path.bounces = options.bounces.value_or(path.bounces);
    path.spread = options.samples.has_value();
    return path;
}

/// Where only lights without a shape send light, and straight, no directions are drawn.
std::vector<LobeTable> lobesOf(World& world, int bounces)
{
    const bool areDrawn = bounces > 0 || world.environment || !world.lights.areaLights.empty();
    std::vector<LobeTable> lobes;
    for (MaterialSlot& slot : world.materials)
        lobes.push_back(areDrawn ? slot.lobes() : LobeTable());
    return lobes;
}

double millisecondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

}  // namespace

CpuDrawing::CpuDrawing(const Options& options, World& world, CpuRequest request)
    : request_(std::move(request)), scene_(sceneOf(world, request_))
{
    if (request_.technique != scene::ViewTechnique::path) return;
    const truth::PathOptions path = pathOptionsOf(options, request_);
    bounces_ = path.bounces;
    tracer_ = std::make_unique<truth::PathTracer>(scene_, lobesOf(world, bounces_), path);
    left_ = options.samples.value_or(kDefaultSamples);
}

void CpuDrawing::goOn()
{
    const scene::PictureOptions size{request_.width, request_.height};
    if (tracer_) {
        tracer_->add(1);
    } else if (request_.technique == scene::ViewTechnique::vertex) {
        image_ = renderVertex(scene_, size);
    } else {
        image_ = renderReference(scene_, size);
    }
    --left_;
}

scene::Image CpuDrawing::image() const
{
    return tracer_ ? tracer_->picture().image : image_;
}

std::optional<scene::PathStats> CpuDrawing::pathStats() const
{
    if (!tracer_) return std::nullopt;
    return scene::PathStats{tracer_->samples(), bounces_, noiseOf(tracer_->picture())};
}

Picture drawOnCpu(const Options& options, World& world)
{
    Picture picture{{}, statsOf(options, world)};
    scene::Stats& stats = picture.stats;
    for (int frame = 0; frame < options.frames.value_or(1); ++frame) {
        const auto start = std::chrono::steady_clock::now();
        CpuDrawing drawing(options, world,
                           {options.technique, world.instances, viewOf(options, world),
                            options.width, options.height});
        while (!drawing.isFinished()) drawing.goOn();
        picture.image = drawing.image();
        stats.path = drawing.pathStats();
        stats.milliseconds.push_back(millisecondsSince(start));
    }
    stats.backend = "cpu";
    stats.accumulation = "double";
    stats.lightsUsed = stats.lightsGiven;
    if (std::all_of(world.materials.begin(), world.materials.end(),
                    [](const MaterialSlot& slot) { return slot.truthIsSource(); }))
        stats.evaluated = "source";
    return picture;
}

}  // namespace fbrdf::viewer

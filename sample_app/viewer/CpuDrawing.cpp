#include "CpuDrawing.h"

#include <fbrdf/scene/KeyLights.h>

#include <algorithm>
#include <chrono>

namespace fbrdf::viewer {
namespace {

std::vector<MaterialSlot*> slotsOf(World& world, const CpuRequest& request)
{
    if (request.only) return {request.only};
    std::vector<MaterialSlot*> slots;
    for (MaterialSlot& slot : world.materials) slots.push_back(&slot);
    return slots;
}

scene::Scene sceneOf(World& world, const CpuRequest& request)
{
    scene::Scene scene;
    scene.instances = request.instances;
    for (MaterialSlot* slot : slotsOf(world, request)) scene.brdfs.push_back(slot->truth());
    scene.lights = world.lights.lights;
    scene.areaLights = world.lights.areaLights;
    if (world.environment) scene.environment = &*world.environment;
    scene.view = request.view;
    if (world.ground && world.ground->isSeenFrom(request.view)) {
        scene.ground = world.ground.get();
        scene.instances.push_back(world.ground->object(static_cast<int>(scene.brdfs.size())));
        scene.brdfs.push_back(scene::Ground::brdf());
    }
    return scene;
}

/// What `objects` hide of the lights that cast shadows.
scene::Shadow shadowOf(const truth::Occluders& occluders,
                       const std::vector<scene::ShadowedLight>& shadowed)
{
    return [&occluders, shadowed](size_t light, const scene::SurfacePoint& point,
                                  const scene::Incident&) {
        const auto found = std::find_if(
            shadowed.begin(), shadowed.end(),
            [light](const auto& caster) { return caster.place == static_cast<int>(light); });
        if (found == shadowed.end()) return false;
        const scene::Incident from = scene::incidentFrom(found->from, point.position);
        return occluders.hide(point, from.direction, from.distance);
    };
}

truth::PathOptions pathOptionsOf(const Options& options, const CpuRequest& request)
{
    truth::PathOptions path;
    path.picture = {request.width, request.height};
    path.bounces = options.bounces.value_or(path.bounces);
    if (request.technique == scene::ViewTechnique::reference) {
        path.bounces = 0;
        path.shadows = false;
    }
    path.spread = options.document.spread;
    return path;
}

/// Where only lights without a shape send light, and straight, no directions are drawn.
std::vector<LobeTable> lobesOf(World& world, const CpuRequest& request, const scene::Scene& scene,
                               int bounces)
{
    const bool areDrawn = bounces > 0 || world.environment || !world.lights.areaLights.empty();
    std::vector<LobeTable> lobes;
    for (MaterialSlot* slot : slotsOf(world, request))
        lobes.push_back(areDrawn ? slot->lobes() : LobeTable());
    if (scene.ground) lobes.emplace_back();  // its directions are drawn by the cosine
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
    left_ = samplesOf(options, request_.technique);
    if (options.document.shadows && request_.technique != scene::ViewTechnique::path)
        occluders_.emplace(request_.instances);
    if (!isRandom(options, request_.technique)) {
        sum_ = scene::Image(request_.width, request_.height);
        return;
    }
    const truth::PathOptions path = pathOptionsOf(options, request_);
    bounces_ = path.bounces;
    tracer_ = std::make_unique<truth::PathTracer>(scene_,
                                                  lobesOf(world, request_, scene_, bounces_), path);
}

void CpuDrawing::goOn(double milliseconds)
{
    if (occluders_)
        scene_.shadow = shadowOf(
            *occluders_, shadowedLights(scene_.lights, scene::boundsOf(request_.instances), done_));
    if (tracer_) {
        constexpr int kRows = 8;  // enough for every core to have some
        const auto start = std::chrono::steady_clock::now();
        do tracer_->addRows(kRows);
        while (tracer_->samples() == done_ && millisecondsSince(start) < milliseconds);
        if (tracer_->samples() == done_) return;
    } else {
        scene::PictureOptions options{request_.width, request_.height};
        options.firstSample = done_;
        add(request_.technique == scene::ViewTechnique::vertex ? renderVertex(scene_, options)
                                                               : renderReference(scene_, options),
            sum_);
    }
    ++done_;
    --left_;
}

scene::Image CpuDrawing::image() const
{
    return tracer_ ? tracer_->picture().image : meanOf(sum_, done_);
}

std::optional<scene::PathStats> CpuDrawing::pathStats() const
{
    if (!tracer_) return std::nullopt;
    return scene::PathStats{tracer_->samples(), bounces_, noiseOf(tracer_->picture())};
}

Picture drawOnCpu(const Options& options, World& world)
{
    Picture picture{{}, statsOf(options, world), viewOf(options, world)};
    scene::Stats& stats = picture.stats;
    for (int frame = 0; frame < options.frames.value_or(1); ++frame) {
        const auto start = std::chrono::steady_clock::now();
        CpuDrawing drawing(options, world,
                           {options.document.technique, world.instances, viewOf(options, world),
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

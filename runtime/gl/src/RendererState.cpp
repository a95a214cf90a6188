#include "RendererState.h"

#include "RoundingProbe.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Parallel.h>

#include <algorithm>
#include <utility>

namespace fbrdf::gl {
namespace {

constexpr int kMostThreads = 4;  // that move lights to eye space

/// True where some pass writes a surface of ours, which must then exist.
bool needsSurfaces(const Plan& plan)
{
    return std::any_of(plan.passes.begin(), plan.passes.end(),
                       [](const Pass& pass) { return pass.writes != Surface::target; });
}

/// Statistics are those of the worst item: a host wants to know what a draw may cost at most.
void addPlan(DrawStats& stats, const Plan& plan)
{
    const int passes = static_cast<int>(plan.passes.size());
    // Name and format go with the item of most passes; bounds are the worst of all.
    if (passes > stats.passes) {
        stats.accumulation = colourFormatName(plan.accumulation);
        stats.whyAccumulation = plan.whyAccumulation;
        stats.technique = plan.technique;
        stats.filter = plan.filter;
    }
    stats.error = {std::max(stats.error.relative, plan.error.relative),
                   std::max(stats.error.absolute, plan.error.absolute),
                   {std::max(stats.error.maps.recombination, plan.error.maps.recombination),
                    std::max(stats.error.maps.filtering, plan.error.maps.filtering),
                    std::max(stats.error.maps.absolute, plan.error.maps.absolute),
                    std::max(stats.error.maps.exponent, plan.error.maps.exponent)}};
    stats.environmentError = std::max(stats.environmentError, plan.lobeError);
    stats.passes = std::max(stats.passes, passes);
    stats.drawCalls += passes;
}

/// The lobes by which an item reflects an environment and area lights.
struct ItemLobes {
    LobeLayout layout = {};            ///< no lobes: there are none
    const LobeTable* table = nullptr;  ///< null where they are packed
    double error = 0.0;
    std::string whyNot = {};  ///< why an item has none although it needs some
};

ItemLobes packedLobesOf(const MaterialResources& material)
{
    ItemLobes lobes{material.packedLobes(), nullptr, material.lobeError()};
    if (lobes.layout.lobes == 0)
        lobes.whyNot = Found("materials of a packed library without lobes").expected("fitted ones");
    return lobes;
}

ItemLobes lobesOf(const MaterialResources& material, int most)
{
    if (material.isPacked()) return packedLobesOf(material);
    const LobeTable* const table = material.lobes().find(most);
    if (table) return {layoutOf(*table), table, table->error};
    return {{}, nullptr, 0.0, material.lobes().whyNot()};
}

/// The irradiance of all lights that may reach an object, at most.
double irradianceOf(const EyeLights& lights, const Sphere& bounds, const DrawRequest& draw)
{
    double sum = 0.0;
    if (!draw.clusters)
        for (const double peak : lights.peaks) sum += peak;
    else
        for (const Light& light : draw.lights) sum += largestIrradiance(light, bounds);
    return sum;
}

}  // namespace

Renderer::State::State(const DevicePtr& d, const RendererOptions& options)
    : device(d),
      programs(d, options.idlePrograms),
      surfaces(d),
      clusterBuffers(d),
      areaBuffers(d),
      listKernel(d),
      instances(d, GL_RGBA32F, "instances"),
      workers(std::min(threadCount(0), kMostThreads))
{
}

void Renderer::State::checkAlive() const
{
    if (!device->alive)
        throw Error(ErrorKind::gl, "renderer",
                    Found("an abandoned context").expected("a live one"));
}

void Renderer::State::checkOwner(const Device* owner) const
{
    if (owner != device.get())
        throw Error(
            ErrorKind::usage, "item",
            Found("a material, mesh or hooks of another renderer").expected("those of this"));
}

Drawable Renderer::State::drawableOf(const Item& item) const
{
    if (!item.material || !item.mesh)
        throw Error(ErrorKind::usage, "item", Found("none").expected("a material and a mesh"));
    const MaterialResources& material = item.material->resources();
    const MeshResources& mesh = item.mesh->resources();
    const CompiledHooks* const hooks = item.hooks ? &item.hooks->compiled() : nullptr;
    checkOwner(material.device());
    checkOwner(mesh.device());
    if (hooks) checkOwner(hooks->device());
    return {material, mesh, surfaceOptions(mesh, material, hooks, item.normalMap), item.model, {}};
}

void checkModel(const glm::mat4& model)
{
    if (!isInvertible(model))
        throw Error(ErrorKind::usage, "item",
                    Found("a singular model matrix").expected("an invertible one"));
}

PlanRequest Renderer::State::request(const DrawOptions& options, int lights,
                                     const TargetInfo& target) const
{
    PlanRequest request;
    request.technique = options.technique;
    request.lights = lights;
    request.lightsPerPass = options.lightsPerPass;
    request.maxLookups = options.maxLookups;
    request.target = target.format;
    request.otherUnit = target.otherUnit;
    // Edges of a multisampled target would read texels of a surface of one sample that nothing was
    // drawn to. ES has the functions too, but they are not loaded there.
    request.resolves = target.samples > 1;
    request.offscreen = !request.resolves || device->gl.version >= 30;
    request.transfer = target.transfer;
    request.accumulation = options.accumulation;
    if (device->roundings) request.roundings = *device->roundings;
    return request;
}

std::vector<const Program*> Renderer::State::programsOf(const MaterialResources& material,
                                                        const SurfaceOptions& surface,
                                                        const Plan& plan, bool clustered,
                                                        bool areaLists)
{
    // What hooks of the host need of units and uniforms is not left for lights.
    const Capabilities capabilities = remaining(device->capabilities, surface.hooks);
    std::vector<const Program*> result;
    for (const Pass& pass : plan.passes) {
        ProgramSpec spec =
            programSpec(pass, maxLightsInUniforms(material.form(), capabilities, pass.lobes));
        spec.clustered = clustered && pass.lit;
        spec.areaLists = areaLists && spec.lobes.areaSlots > 0;
        spec.resolved = spec.reads && plan.resolves;
        result.push_back(&programs.find(material, spec, surface));
    }
    return result;
}

ReadyPlan Renderer::State::planOf(const Form& form, PlanRequest& wanted,
                                  const Capabilities& capabilities, const DrawRequest* draw)
{
    ReadyPlan ready{planPasses(form, wanted, capabilities), nullptr, {}};
    if (!draw || !needsSurfaces(ready.plan)) return ready;
    const Target& target = draw->target;
    const auto find = [&] {
        return surfaces.find(target.framebuffer, {target.width, target.height, ready.plan.surfaces,
                                                  draw->info.floatDepth, draw->info.samples});
    };
    // The driver knows only now whether surfaces of this format and size can be made.
    ready.surfaces = find();
    if (!ready.surfaces && ready.plan.surfaces != ColourFormat::rgba32f &&
        capabilities.floatTargets) {
        wanted.accumulation = ColourFormat::rgba32f;
        ready.plan = planPasses(form, wanted, capabilities);
        if (!needsSurfaces(ready.plan)) return ready;
        ready.surfaces = find();
    }
    if (ready.surfaces) return ready;
    // A context may promise a format and refuse its size: the plan is made again for the target
    // alone.
    wanted.offscreen = false;
    return {planPasses(form, wanted, capabilities), nullptr, {}};
}

ReadyPlan Renderer::State::sampledPlan(const MaterialResources& material, PlanRequest& wanted,
                                       const Capabilities& capabilities, const DrawRequest* draw,
                                       PlanNotes& notes)
{
    ReadyPlan ready;
    if (material.isPacked())
        ready.plan.reason = Found("a material of a packed library").expected("one by itself");
    else
        ready = planOf(material.form(), wanted, capabilities, draw);
    if (ready.plan.feasible()) return ready;
    notes.whyNotSampled = ready.plan.reason;
    device->logOnce(Severity::warning,
                    "material '" + material.name() +
                        "': directions of the environment replaced by lobes: " + ready.plan.reason);
    wanted.environmentSamples = 0;
    return ready;
}

ReadyPlan Renderer::State::planFor(const MaterialResources& material, const CompiledHooks* hooks,
                                   PlanRequest wanted, const DrawRequest* draw, PlanNotes& notes)
{
    const Capabilities capabilities = remaining(device->capabilities, hooks);
    wanted.signs = material.hasSigns();
    wanted.filter = material.filter();
    if (wanted.environmentSamples > 0) {
        ReadyPlan sampled = sampledPlan(material, wanted, capabilities, draw, notes);
        if (sampled.plan.feasible()) return sampled;
    }
    ReadyPlan ready = planOf(material.form(), wanted, capabilities, draw);
    if (ready.plan.feasible()) return ready;
    // The lights are drawn as asked for where even one pass cannot have the lobes; area lights are
    // kept where only the environment is impossible.
    while (!wanted.lobeLight.isEmpty()) {
        PlanRequest single = wanted;
        single.technique = Technique::single;
        single.maxLookups = 0;
        const ReadyPlan together = planOf(material.form(), single, capabilities, draw);
        if (together.plan.feasible()) break;
        notes.whyNoEnvironment = together.plan.reason;
        wanted.lobeLight.areaLights =
            wanted.lobeLight.environment ? wanted.lobeLight.areaLights : 0;
        wanted.lobeLight.environment = false;
        ready = planOf(material.form(), wanted, capabilities, draw);
        if (ready.plan.feasible()) return ready;
    }
    // Once for each text, and so for each material and reason: draws come 60 times a second.
    device->logOnce(Severity::warning, "material '" + material.name() +
                                           "': " + techniqueName(wanted.technique) +
                                           " replaced by single: " + ready.plan.reason);
    notes.whyReplaced = ready.plan.reason;
    // `single` without a limit has a plan for every form, unless its tables need too many units.
    wanted.technique = Technique::single;
    wanted.maxLookups = 0;
    ready = planOf(material.form(), wanted, capabilities, draw);
    if (!ready.plan.feasible())
        device->logOnce(Severity::error,
                        "material '" + material.name() + "' not drawn: " + ready.plan.reason);
    return ready;
}

void Renderer::State::prepareFirst(const MaterialResources& material)
{
    storeRoundings(device);
    prepare(material, {}, {}, 1);
    // Not before: what keeps a filter from being measured most often refuses the material too.
    const std::string why = std::exchange(device->whyFilterAssumed, "");
    if (!why.empty())
        device->logOnce(Severity::warning,
                        "how finely textures are filtered was not measured, 8 bits between texels "
                        "are assumed: " +
                            why);
}

void Renderer::State::prepare(const MaterialResources& material, const SurfaceOptions& surface,
                              const DrawOptions& options, int lights)
{
    programs.evict();
    // Linking sets samplers, for which the program has to be current: state changes here too.
    const StateGuard guard(*device);
    PlanNotes notes;
    // An RGBA32F target needs no surfaces, and so no size, which is not known yet.
    const TargetInfo floatTarget{ColourFormat::rgba32f, {}, 1, false, Transfer::linear};
    PlanRequest wanted = request(options, lights, floatTarget);
    wanted.maps = material.mapErrors(0.0);
    wanted.lobeLight = {options.environment.map != nullptr,
                        static_cast<int>(options.areaLights.size())};
    if (!wanted.lobeLight.isEmpty()) {
        if (!material.isPacked()) material.lobes().wait();
        wanted.lobes = lobesOf(material, options.environment.lobes).layout;
        if (wanted.lobes.lobes == 0) wanted.lobeLight = {};
        if (wanted.lobeLight.environment) wanted.environmentSamples = options.environment.samples;
    }
    const ReadyPlan ready = planFor(material, surface.hooks, wanted, nullptr, notes);
    const bool lists = hasLists(options, static_cast<size_t>(lights)),
               areaLists = hasAreaLists(options, options.areaLights.size());
    programsOf(material, surface, ready.plan, lists, areaLists);
    if (lists || areaLists) whyListsByCpu(options);  // builds the program that makes them
}

void Renderer::State::draw(Executor& executor, const Drawable& item, const Sphere& bounds,
                           const DrawRequest& draw, DrawStats& stats)
{
    const MaterialResources& material = item.material;
    const DebugGroup group(*device, "fbrdf item " + material.name());
    // An arbitrary frame is invisible in an isotropic material only.
    if (material.isAnisotropic() && !item.mesh.hasTangents() && !item.surface.derivedTangent)
        device->logOnce(Severity::warning,
                        "material '" + material.name() +
                            "' is anisotropic, the mesh has neither tangents nor texture "
                            "coordinates");
    // With clustered lights the plan is made for a single light: programs read the lists.
    EyeLights lights = draw.clusters
                           ? EyeLights{{draw.eye.vectors.front()}, {draw.eye.numbers.front()}, {}}
                           : lightsOf(bounds, draw, stats);
    // So they are with lists of area lights, but not where none of them reaches the item.
    lights.areas = areasOf(bounds, draw, stats);
    if (draw.areaClusters && lights.areas.size() > 1) lights.areas.resize(1);
    // A batch of lights is scissored to the pixels that any of them reaches.
    if (draw.options.technique == Technique::batched) putNeighboursTogether(lights, draw);
    PlanRequest wanted = request(draw.options, static_cast<int>(lights.vectors.size()), draw.info);
    // Lists have no peaks: how many lights reach a pixel is not known here.
    if (!draw.clusters) {
        wanted.peaks = material.peaks();
        wanted.peaks->lights = lights.peaks;
    }
    wanted.maps = material.mapErrors(irradianceOf(lights, bounds, draw));
    wanted.lobeLight = {draw.environment.map != nullptr, static_cast<int>(lights.areas.size())};
    ItemLobes lobes;
    if (!wanted.lobeLight.isEmpty()) lobes = lobesOf(material, draw.options.environment.lobes);
    if (lobes.layout.lobes == 0) wanted.lobeLight = {};
    wanted.lobes = lobes.layout;
    wanted.lobeError = lobes.error;
    if (wanted.lobeLight.environment) wanted.environmentSamples = draw.environment.samples;
    PlanNotes notes{"", lobes.whyNot, ""};
    ReadyPlan ready = planFor(material, item.surface.hooks, wanted, &draw, notes);
    ready.lobes = lobes.table;
    if (!notes.whyReplaced.empty()) stats.whyReplaced = notes.whyReplaced;
    if (!notes.whyNotSampled.empty()) stats.whyNotSampled = notes.whyNotSampled;
    if (!notes.whyNoEnvironment.empty())
        leaveEnvironmentOut(material, notes.whyNoEnvironment, std::max(1, item.instances.count),
                            stats);
    ready.programs = programsOf(material, item.surface, ready.plan, draw.clusters != nullptr,
                                draw.areaClusters != nullptr);
    stats.maxLookups = std::max(stats.maxLookups, executor.draw(item, ready, lights));
    addPlan(stats, ready.plan);
}

void Renderer::State::leaveEnvironmentOut(const MaterialResources& material, const std::string& why,
                                          int objects, DrawStats& stats)
{
    stats.itemsWithoutEnvironment += objects;
    stats.whyNoEnvironment = why;
    device->logOnce(
        Severity::warning,
        "material '" + material.name() + "' drawn without the environment or area lights: " + why);
}

void Renderer::State::drawItem(Executor& executor, const Item& item, const DrawRequest& request,
                               DrawStats& stats)
{
    attempt(stats, 1, [&] { drawObject(executor, drawableOf(item), request, stats); });
}

void Renderer::State::drawObject(Executor& executor, const Drawable& object,
                                 const DrawRequest& request, DrawStats& stats)
{
    // Prepared items need no model matrix, so drawableOf does not check it.
    checkModel(object.model);
    draw(executor, object,
         worldBounds(reached(object.mesh.bounds(), object.surface.hooks), object.model), request,
         stats);
}

DrawStats Renderer::State::draw(const Target& target, const View& view,
                                const std::vector<Light>& lights, const DrawOptions& options,
                                const DrawAll& drawAll)
{
    checkAlive();
    checkRequest(*device, target, view);
    // Between draws nothing of ours is in use, so what no material needs any more can go.
    programs.evict();
    surfaces.evict(target);
    DrawRequest request{target, view, options, {}, {}, {}, {}, {}, {}, {}, {}, {}};
    request.eyePoint = glm::vec4(eyeFromProjection(glm::dmat4(view.projection)));
    setLights(request, lights, workers);
    setAreaLights(request, *device, static_cast<int>(lights.size()));
    setEnvironment(request, *device);
    DrawStats stats;
    stats.lightsGiven = static_cast<int>(lights.size() + options.areaLights.size());
    stats.lightsUsed = static_cast<int>(request.lights.size() + request.areaLights.size());
    stats.lightsDropped = stats.lightsGiven - stats.lightsUsed;

    // The guard comes before all that touches state, and ends after the executor.
    StateGuard guard(*device);
    const DebugGroup group(*device, "fbrdf draw");
    guard.setTarget(target);
    guard.setDepth(view.depth);
    // The format is queried each time: a host may attach other buffers to the same framebuffer.
    request.info = targetInfo(*device, target);
    validate(this->request(options, static_cast<int>(request.lights.size()), request.info));
    if (options.maxLights < 0)
        throw Error(ErrorKind::usage, "draw",
                    Found("a limit of " + std::to_string(options.maxLights) + " lights")
                        .expected("0 (none) or more"));
    cluster(request, stats);
    clusterAreas(request, stats);
    Executor executor(*device, request, clusterBuffers, areaBuffers, guard);
    drawAll(executor, request, stats);
    return stats;
}

}  // namespace fbrdf::gl

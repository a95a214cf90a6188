#include "DrawRequest.h"
#include "Executor.h"
#include "GpuLibrary.h"

#include <fbrdf/brdf/Error.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <algorithm>
#include <tuple>

namespace fbrdf::gl {
namespace {

constexpr const char* kNoLists =
    "found lists of lights asked for, expected OpenGL 3.1, technique single and no limits";

}  // namespace

struct Renderer::State {
    DevicePtr device;
    ProgramCache programs;
    Surfaces surfaces;
    ClusterBuffers clusterBuffers;
    BufferTexture instances;

    explicit State(const DevicePtr& d)
        : device(d),
          programs(d),
          surfaces(d),
          clusterBuffers(d),
          instances(d, GL_RGBA32F, "instances")
    {
    }

    void checkAlive() const
    {
        if (!device->alive)
            throw Error(ErrorKind::gl, "renderer",
                        "found an abandoned context, expected a live one");
    }

    PlanRequest request(const DrawOptions& options, int lights, const TargetInfo& target) const
    {
        return {options.technique,  lights,        options.lightsPerPass,
                options.maxLookups, target.format, !target.multisampled,
                target.transfer};
    }

    std::vector<const Program*> programsOf(const GpuMaterial& material, const Plan& plan,
                                           bool clustered)
    {
        const int maxLights = maxLightsInUniforms(material.form(), device->capabilities);
        std::vector<const Program*> result;
        for (const Pass& pass : plan.passes) {
            ProgramSpec spec = programSpec(pass, maxLights);
            spec.clustered = clustered && pass.lit;
            result.push_back(&programs.find(material, spec));
        }
        return result;
    }

    /// The plan asked for; where there is none, all lights in one pass, with a warning.
    Plan planFor(const GpuMaterial& material, PlanRequest wanted, const Target* target,
                 std::string& whyReplaced)
    {
        wanted.signs = material.hasSigns();
        Plan plan = planPasses(material.form(), wanted, device->capabilities);
        const auto isOffscreen = [](const Pass& pass) { return pass.writes != Surface::target; };
        if (target && std::any_of(plan.passes.begin(), plan.passes.end(), isOffscreen) &&
            !surfaces.prepare(target->width, target->height)) {
            wanted.offscreen = false;
            plan = planPasses(material.form(), wanted, device->capabilities);
        }
        if (plan.feasible()) return plan;
        device->logOnce(Severity::warning, "material '" + material.name() +
                                               "': " + techniqueName(wanted.technique) +
                                               " replaced by single: " + plan.reason);
        whyReplaced = plan.reason;
        wanted.technique = Technique::single;
        wanted.maxLookups = 0;
        plan = planPasses(material.form(), wanted, device->capabilities);
        if (!plan.feasible())
            device->logOnce(Severity::error,
                            "material '" + material.name() + "' not drawn: " + plan.reason);
        return plan;
    }

    /// What materials come from, and a mesh.
    template <class Source>
    void checkOwners(const Source* source, const GpuMesh* mesh) const
    {
        if (!source || !mesh)
            throw Error(ErrorKind::usage, "item", "found none, expected a material and a mesh");
        if (source->device() != device.get() || mesh->device() != device.get())
            throw Error(ErrorKind::usage, "item",
                        "found a material or mesh of another renderer, expected one of this");
    }

    static void checkModel(const glm::mat4& model)
    {
        if (!isInvertible(model))
            throw Error(ErrorKind::usage, "item",
                        "found a singular model matrix, expected an invertible one");
    }

    /// The lights of one item, as its plan counts them; with lists one stands for all.
    std::vector<LightVectors> lightsOf(const Sphere& bounds, const DrawRequest& draw,
                                       DrawStats& stats)
    {
        if (draw.clustered) return {draw.vectors.begin(), draw.vectors.begin() + 1};
        const LightSelection selection = selectLights(draw.lights, bounds, draw.options.maxLights);
        stats.lightsCulled += selection.culled;
        stats.lightsDropped =
            std::max(stats.lightsDropped,
                     stats.lightsGiven - static_cast<int>(draw.lights.size()) + selection.dropped);
        std::vector<LightVectors> vectors;
        for (const int i : selection.lights)
            vectors.push_back(draw.vectors[static_cast<size_t>(i)]);
        return vectors;
    }

    void draw(Executor& executor, const Drawable& item, const Sphere& bounds,
              const DrawRequest& draw, DrawStats& stats)
    {
        const GpuMaterial& material = item.material;
        const DebugGroup group(*device, "fbrdf item " + material.name());
        if (!isIsotropic(material.form()) && !item.mesh.hasTangents())
            device->logOnce(Severity::warning, "material '" + material.name() +
                                                   "' is anisotropic, the mesh has no tangents");
        const auto lights = lightsOf(bounds, draw, stats);
        const Plan plan =
            planFor(material, request(draw.options, static_cast<int>(lights.size()), draw.info),
                    &draw.target, stats.whyReplaced);
        const auto passPrograms = programsOf(material, plan, draw.clustered);
        stats.maxLookups =
            std::max(stats.maxLookups, executor.draw(item, plan, passPrograms, lights));
        const int passes = static_cast<int>(plan.passes.size());
        if (passes > stats.passes) {
            stats.accumulation = colourFormatName(plan.accumulation);
            stats.technique = plan.technique;
        }
        stats.error = {std::max(stats.error.relative, plan.error.relative),
                       std::max(stats.error.absolute, plan.error.absolute)};
        stats.passes = std::max(stats.passes, passes);
        stats.drawCalls += passes;
    }

    /// What fails is left out, logged and counted.
    template <class Draw>
    void survive(DrawStats& stats, int objects, Draw drawIt)
    {
        try {
            drawIt();
        } catch (const Error& error) {
            stats.itemsFailed += objects;
            device->logOnce(Severity::error, error.what());
        }
    }

    void drawOne(Executor& executor, const GpuMaterial& material, const GpuMesh& mesh,
                 const glm::mat4& model, const DrawRequest& request, DrawStats& stats)
    {
        checkModel(model);
        draw(executor, {material, mesh, model}, worldBounds(mesh, model), request, stats);
    }

    /// The instances that can be drawn, by the group that holds their material.
    std::vector<std::vector<const Instance*>> sorted(const Batch& batch, DrawStats& stats)
    {
        const auto& places = batch.library->places();
        std::vector<std::vector<const Instance*>> result(batch.library->groupCount());
        for (const Instance& instance : batch.instances)
            survive(stats, 1, [&] {
                const auto index = static_cast<size_t>(instance.material);
                if (instance.material < 0 || index >= places.size())
                    throw Error(ErrorKind::usage, "item",
                                "found material " + std::to_string(instance.material) +
                                    ", expected one of " + std::to_string(places.size()));
                checkModel(instance.model);
                result[places[index].group].push_back(&instance);
            });
        return result;
    }

    /// Draws [first, last) in one call a pass.
    void drawPacked(Executor& executor, const Batch& batch, const GpuMaterial& material,
                    const Instance* const* first, const Instance* const* last,
                    const DrawRequest& request, DrawStats& stats)
    {
        std::vector<InstanceTexels> texels;
        std::vector<Sphere> bounds;
        for (const Instance* const* i = first; i != last; ++i) {
            const auto& place = batch.library->places()[static_cast<size_t>((*i)->material)];
            texels.push_back(instanceTexels(modelView(request.view, (*i)->model),
                                            static_cast<int>(place.layer)));
            bounds.push_back(worldBounds(*batch.mesh, (*i)->model));
        }
        instances.update(texels.size() * texels[0].size(), texels.size() * sizeof texels[0],
                         texels.data());
        draw(executor,
             {material, *batch.mesh, {}, {instances.texture(), static_cast<int>(texels.size())}},
             enclosing(bounds), request, stats);
    }

    void drawGroup(Executor& executor, const Batch& batch, const GpuMaterial& material,
                   const std::vector<const Instance*>& objects, const DrawRequest& request,
                   DrawStats& stats)
    {
        if (!material.isPacked()) {
            for (const Instance* object : objects)
                survive(stats, 1, [&] {
                    drawOne(executor, material, *batch.mesh, object->model, request, stats);
                });
            return;
        }
        const auto most =
            static_cast<size_t>(device->maxBufferTexels) / std::tuple_size_v<InstanceTexels>;
        for (size_t first = 0; first < objects.size(); first += most) {
            const size_t count = std::min(most, objects.size() - first);
            survive(stats, static_cast<int>(count), [&] {
                drawPacked(executor, batch, material, &objects[first], &objects[first] + count,
                           request, stats);
            });
        }
    }

    /// Whether lights go into lists: asked for, possible, and there are any.
    bool isClustered(const DrawOptions& options, size_t lights)
    {
        if (!options.clustered || lights == 0) return false;
        const bool possible = options.technique == Technique::single && options.maxLookups == 0 &&
                              options.maxLights == 0 && device->capabilities.bufferTextures;
        if (!possible)
            device->logOnce(Severity::warning, std::string(kNoLists) + ": drawing without");
        return possible;
    }

    /// Sets everything up for a draw, then drawAll(executor, request, stats).
    template <class DrawAll>
    DrawStats draw(const Target& target, const View& view, const std::vector<Light>& lights,
                   const DrawOptions& options, DrawAll drawAll)
    {
        checkAlive();
        checkRequest(*device, target, view);
        DrawRequest request{target, view, options, {}, usableLights(lights, target), {}};
        request.vectors = lightVectors(request.lights, view);
        DrawStats stats;
        stats.lightsGiven = static_cast<int>(lights.size());
        stats.lightsUsed = static_cast<int>(request.lights.size());
        stats.lightsDropped = stats.lightsGiven - stats.lightsUsed;

        StateGuard guard(*device);
        const DebugGroup group(*device, "fbrdf draw");
        guard.setTarget(target);
        request.info = targetInfo(*device, target);
        validate(this->request(options, stats.lightsUsed, request.info));
        if (options.maxLights < 0)
            throw Error(ErrorKind::usage, "draw",
                        "found a limit of " + std::to_string(options.maxLights) +
                            " lights, expected 0 (none) or more");
        Frame frame{target, view, glm::vec4(eyeFromProjection(glm::dmat4(view.projection)))};
        LightClusters clusters;
        request.clustered = isClustered(options, request.lights.size());
        if (options.clustered && !request.clustered && !request.lights.empty())
            stats.whyReplaced = kNoLists;
        if (request.clustered) {
            clusters = lightClusters(request.vectors, glm::dmat4(view.projection));
            clusterBuffers.update(clusters);
            frame.clusters = &clusters;
            frame.clusterBuffers = &clusterBuffers;
        }
        Executor executor(*device, frame, surfaces, guard);
        drawAll(executor, request, stats);
        return stats;
    }
};

Renderer::Renderer(const RendererOptions& options)
    : state_(std::make_unique<State>(createDevice(options)))
{
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const std::string& Renderer::glRenderer() const
{
    return state_->device->renderer;
}

const std::string& Renderer::glVersion() const
{
    return state_->device->version;
}

const Capabilities& Renderer::capabilities() const
{
    return state_->device->capabilities;
}

std::shared_ptr<GpuMaterial> Renderer::createMaterial(const Material& material)
{
    state_->checkAlive();
    discardHostErrors(*state_->device);
    auto result = std::make_shared<GpuMaterial>(state_->device, material);
    prepare(*result, {}, 1);
    return result;
}

std::shared_ptr<GpuMesh> Renderer::createMesh(const MeshData& mesh)
{
    state_->checkAlive();
    discardHostErrors(*state_->device);
    return std::make_shared<GpuMesh>(state_->device, mesh);
}

std::shared_ptr<GpuLibrary> Renderer::createLibrary(const std::vector<Material>& materials)
{
    state_->checkAlive();
    discardHostErrors(*state_->device);
    return std::make_shared<GpuLibrary>(state_->device, materials,
                                        [this](const GpuMaterial& made) { prepare(made, {}, 1); });
}

void Renderer::replaceMaterial(GpuLibrary& library, int index, const Material& material)
{
    state_->checkAlive();
    if (library.device() != state_->device.get())
        throw Error(ErrorKind::usage, "library",
                    "found one of another renderer, expected one of this");
    if (index < 0 || static_cast<size_t>(index) >= library.places().size())
        throw Error(ErrorKind::usage, "library",
                    "found material " + std::to_string(index) + ", expected one of " +
                        std::to_string(library.places().size()));
    discardHostErrors(*state_->device);
    library.replace(static_cast<size_t>(index), material,
                    [this](const GpuMaterial& made) { prepare(made, {}, 1); });
}

const std::string& whyApart(const GpuLibrary& library)
{
    return library.reason();
}

void Renderer::prepare(const GpuMaterial& material, const DrawOptions& options, int lights)
{
    state_->checkAlive();
    const StateGuard guard(*state_->device);
    std::string whyReplaced;
    const Plan plan = state_->planFor(
        material,
        state_->request(options, lights, {ColourFormat::rgba32f, false, Transfer::linear}), nullptr,
        whyReplaced);
    state_->programsOf(material, plan, state_->isClustered(options, static_cast<size_t>(lights)));
}

DrawStats Renderer::draw(const Target& target, const View& view, const std::vector<Item>& items,
                         const std::vector<Light>& lights, const DrawOptions& options)
{
    return state_->draw(target, view, lights, options,
                        [&](Executor& executor, const DrawRequest& request, DrawStats& stats) {
                            for (const Item& item : items)
                                state_->survive(stats, 1, [&] {
                                    state_->checkOwners(item.material, item.mesh);
                                    state_->drawOne(executor, *item.material, *item.mesh,
                                                    item.model, request, stats);
                                });
                        });
}

DrawStats Renderer::drawBatch(const Target& target, const View& view, const Batch& batch,
                              const std::vector<Light>& lights, const DrawOptions& options)
{
    return state_->draw(target, view, lights, options,
                        [&](Executor& executor, const DrawRequest& request, DrawStats& stats) {
                            state_->checkOwners(batch.library, batch.mesh);
                            if (!batch.library->reason().empty())
                                state_->device->logOnce(Severity::warning,
                                                        "objects of a library drawn one by one: " +
                                                            batch.library->reason());
                            const auto groups = state_->sorted(batch, stats);
                            for (size_t g = 0; g < groups.size(); ++g)
                                state_->drawGroup(executor, batch, batch.library->group(g),
                                                  groups[g], request, stats);
                        });
}

void Renderer::abandonContext() noexcept
{
    state_->device->alive = false;
}

}  // namespace fbrdf::gl

#include "Executor.h"
#include "TargetInfo.h"

#include <fbrdf/brdf/Error.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::gl {
namespace {

bool isFinite(const glm::mat4& m)
{
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r])) return false;
    return true;
}

void checkView(const View& view)
{
    const auto fail = [](const std::string& what) { throw Error(ErrorKind::usage, "view", what); };
    if (!isFinite(view.view) || !isFinite(view.projection))
        fail("found a number that is not finite, expected finite matrices");
    if (glm::determinant(glm::dmat4(view.projection)) == 0.0)
        fail("found a singular projection, expected an invertible one");
}

void checkTarget(const Device& device, const Target& target)
{
    const auto fail = [](const std::string& what) { throw Error(ErrorKind::gl, "target", what); };
    if (target.width <= 0 || target.height <= 0)
        fail("found " + std::to_string(target.width) + "x" + std::to_string(target.height) +
             " pixels, expected at least one");
    if (!(target.exposure > 0.0f) || !std::isfinite(target.exposure))
        fail("found exposure " + std::to_string(target.exposure) +
             ", expected a finite number above 0");
    if (target.framebuffer != 0 && !device.capabilities.framebufferObjects)
        fail("found framebuffer object " + std::to_string(target.framebuffer) +
             " in a context without framebuffer objects, expected 0");
}

/// The valid ones, exposed: light is linear, so that is where exposure costs nothing.
std::vector<Light> usableLights(const std::vector<Light>& lights, const Target& target)
{
    std::vector<Light> used;
    std::copy_if(lights.begin(), lights.end(), std::back_inserter(used),
                 [](const Light& light) { return isValid(light); });
    if (target.transfer != Transfer::linear)
        for (Light& light : used) light.intensity *= target.exposure;
    return used;
}

/// What one call of draw() is about.
struct DrawRequest {
    const Target& target;
    const DrawOptions& options;
    TargetInfo info;
    std::vector<Light> lights;          ///< the valid ones, exposed
    std::vector<LightVectors> vectors;  ///< of each, in eye space
    bool clustered = false;
};

/// A matrix stretches nothing by more than its Frobenius norm.
Sphere worldBounds(const Item& item)
{
    const Sphere& bounds = item.mesh->bounds();
    const glm::dmat3 linear(item.model);
    const double norm = std::sqrt(glm::dot(linear[0], linear[0]) + glm::dot(linear[1], linear[1]) +
                                  glm::dot(linear[2], linear[2]));
    return {Vec3f(glm::dmat4(item.model) * glm::dvec4(Vec3d(bounds.centre), 1.0)),
            static_cast<float>(norm * static_cast<double>(bounds.radius) * (1.0 + 1e-6))};
}

}  // namespace

struct Renderer::State {
    DevicePtr device;
    ProgramCache programs;
    Surfaces surfaces;
    ClusterBuffers clusterBuffers;

    explicit State(const DevicePtr& d) : device(d), programs(d), surfaces(d), clusterBuffers(d) {}

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
    Plan planFor(const GpuMaterial& material, PlanRequest wanted, const Target* target)
    {
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
        wanted.technique = Technique::single;
        wanted.maxLookups = 0;
        return planPasses(material.form(), wanted, device->capabilities);
    }

    void checkItem(const Item& item) const
    {
        const auto fail = [](const std::string& what) {
            throw Error(ErrorKind::usage, "item", what);
        };
        if (!item.material || !item.mesh) fail("found none, expected a material and a mesh");
        if (item.material->device() != device.get() || item.mesh->device() != device.get())
            fail("found a material or mesh of another renderer, expected one of this");
        if (!isFinite(item.model) || glm::determinant(glm::dmat3(item.model)) == 0.0)
            fail("found a singular model matrix, expected an invertible one");
    }

    /// The lights of one item, as its plan counts them; with lists one stands for all.
    std::vector<LightVectors> lightsOf(const Item& item, const DrawRequest& draw, DrawStats& stats)
    {
        if (draw.clustered) return {draw.vectors.begin(), draw.vectors.begin() + 1};
        const LightSelection selection =
            selectLights(draw.lights, worldBounds(item), draw.options.maxLights);
        stats.lightsCulled += selection.culled;
        stats.lightsDropped =
            std::max(stats.lightsDropped,
                     stats.lightsGiven - static_cast<int>(draw.lights.size()) + selection.dropped);
        std::vector<LightVectors> vectors;
        for (const int i : selection.lights)
            vectors.push_back(draw.vectors[static_cast<size_t>(i)]);
        return vectors;
    }

    void drawItem(Executor& executor, const Item& item, const DrawRequest& draw, DrawStats& stats)
    {
        checkItem(item);
        const DebugGroup group(*device, "fbrdf item " + item.material->name());
        if (!isIsotropic(item.material->form()) && !item.mesh->hasTangents())
            device->logOnce(Severity::warning, "material '" + item.material->name() +
                                                   "' is anisotropic, the mesh has no tangents");
        const auto lights = lightsOf(item, draw, stats);
        const Plan plan = planFor(*item.material,
                                  request(draw.options, static_cast<int>(lights.size()), draw.info),
                                  &draw.target);
        const auto passPrograms = programsOf(*item.material, plan, draw.clustered);
        stats.maxLookups =
            std::max(stats.maxLookups, executor.draw(item, plan, passPrograms, lights));
        const int passes = static_cast<int>(plan.passes.size());
        if (passes > stats.passes) stats.accumulation = colourFormatName(plan.accumulation);
        stats.passes = std::max(stats.passes, passes);
        stats.drawCalls += passes;
    }

    /// Whether lights go into lists: asked for, possible, and there are any.
    bool isClustered(const DrawOptions& options, size_t lights)
    {
        if (!options.clustered || lights == 0) return false;
        const bool possible = options.technique == Technique::single && options.maxLookups == 0 &&
                              options.maxLights == 0 && device->capabilities.bufferTextures;
        if (!possible)
            device->logOnce(
                Severity::warning,
                "found lists of lights asked for, expected OpenGL 3.1, technique single "
                "and no limits: drawing without");
        return possible;
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

void Renderer::prepare(const GpuMaterial& material, const DrawOptions& options, int lights)
{
    state_->checkAlive();
    const StateGuard guard(*state_->device);
    const Plan plan = state_->planFor(
        material,
        state_->request(options, lights, {ColourFormat::rgba32f, false, Transfer::linear}),
        nullptr);
    state_->programsOf(material, plan, state_->isClustered(options, static_cast<size_t>(lights)));
}

DrawStats Renderer::draw(const Target& target, const View& view, const std::vector<Item>& items,
                         const std::vector<Light>& lights, const DrawOptions& options)
{
    state_->checkAlive();
    const Device& device = *state_->device;
    checkTarget(device, target);
    checkView(view);
    DrawRequest request{target, options, {}, usableLights(lights, target), {}};
    request.vectors = lightVectors(request.lights, view);
    DrawStats stats;
    stats.lightsGiven = static_cast<int>(lights.size());
    stats.lightsUsed = static_cast<int>(request.lights.size());
    stats.lightsDropped = stats.lightsGiven - stats.lightsUsed;

    StateGuard guard(device);
    const DebugGroup group(device, "fbrdf draw");
    guard.setTarget(target);
    request.info = targetInfo(device, target);
    validate(state_->request(options, stats.lightsUsed, request.info));
    if (options.maxLights < 0)
        throw Error(ErrorKind::usage, "draw",
                    "found a limit of " + std::to_string(options.maxLights) +
                        " lights, expected 0 (none) or more");
    Frame frame{target, view, glm::vec4(eyeFromProjection(glm::dmat4(view.projection)))};
    LightClusters clusters;
    request.clustered = state_->isClustered(options, request.lights.size());
    if (request.clustered) {
        clusters = lightClusters(request.vectors, glm::dmat4(view.projection));
        state_->clusterBuffers.update(clusters);
        frame.clusters = &clusters;
        frame.clusterBuffers = &state_->clusterBuffers;
    }
    Executor executor(device, frame, state_->surfaces, guard);
    for (const Item& item : items) {
        try {
            state_->drawItem(executor, item, request, stats);
        } catch (const Error& error) {
            ++stats.itemsFailed;
            state_->device->logOnce(Severity::error, error.what());
        }
    }
    return stats;
}

void Renderer::abandonContext() noexcept
{
    state_->device->alive = false;
}

}  // namespace fbrdf::gl

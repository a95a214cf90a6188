#include "EnvironmentMaker.h"
#include "RendererState.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/shaders/ShaderSource.h>

namespace fbrdf::gl {

Renderer::Renderer(const RendererOptions& options)
    : state_(std::make_unique<State>(createDevice(options), options))
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

std::shared_ptr<GpuMaterial> Renderer::createMaterial(const Material& material,
                                                      const MaterialOptions& options)
{
    state_->checkAlive();
    discardHostErrors(*state_->device);
    // A map that cannot be recombined is no failure: it is looked up as it is, and the host can ask
    // why.
    const auto resources = std::make_shared<MaterialResources>(state_->device, material, options);
    if (!resources->whyNotRecombined().empty())
        state_->device->log(Severity::warning, "material '" + resources->name() + "' has no " +
                                                   lookUpName(options.lookUp) +
                                                   " maps: " + resources->whyNotRecombined());
    // A material that GL cannot draw is refused here, not in every draw.
    state_->prepareFirst(*resources);
    return std::make_shared<GpuMaterial>(resources);
}

std::shared_ptr<GpuMesh> Renderer::createMesh(const MeshData& mesh)
{
    state_->checkAlive();
    discardHostErrors(*state_->device);
    return std::make_shared<GpuMesh>(std::make_shared<MeshResources>(state_->device, mesh));
}

std::shared_ptr<GpuMesh> Renderer::createMesh(const MeshBuffers& mesh)
{
    state_->checkAlive();
    discardHostErrors(*state_->device);
    return std::make_shared<GpuMesh>(std::make_shared<MeshResources>(state_->device, mesh));
}

std::shared_ptr<GpuEnvironment> Renderer::createEnvironment(const Panorama& panorama,
                                                            const EnvironmentOptions& options)
{
    state_->checkAlive();
    validate(panorama, "environment");
    discardHostErrors(*state_->device);
    const EnvironmentFormat format = environmentFormat(*state_->device, options);
    return std::make_shared<GpuEnvironment>(makeEnvironment(state_->device, panorama, format));
}

std::shared_ptr<GpuEnvironment> Renderer::createEnvironment(const HostEnvironment& source,
                                                            const EnvironmentOptions& options)
{
    state_->checkAlive();
    discardHostErrors(*state_->device);
    const EnvironmentFormat format = environmentFormat(*state_->device, options);
    return std::make_shared<GpuEnvironment>(makeEnvironment(state_->device, source, format));
}

std::shared_ptr<GpuEnvironment> Renderer::createEnvironment(const CubeImage& prefiltered,
                                                            const EnvironmentOptions& options)
{
    state_->checkAlive();
    discardHostErrors(*state_->device);
    EnvironmentOptions asMade = options;
    if (asMade.size == 0) asMade.size = prefiltered.size;
    const EnvironmentFormat format = environmentFormat(*state_->device, asMade);
    return std::make_shared<GpuEnvironment>(
        std::make_shared<EnvironmentResources>(state_->device, prefiltered, format, ""));
}

bool Renderer::refine(GpuEnvironment& environment, long long texels)
{
    state_->checkAlive();
    EnvironmentResources& resources = environment.resources();
    if (resources.device() != state_->device.get())
        throw Error(ErrorKind::usage, "environment",
                    Found("one of another renderer").expected("one of this renderer"));
    if (texels < 1)
        throw Error(ErrorKind::usage, "environment",
                    Found(std::to_string(texels) + " texels to refine").expected("at least 1"));
    discardHostErrors(*state_->device);
    resources.refine(texels);
    return resources.isFinished();
}

std::shared_ptr<GpuHooks> Renderer::createHooks(const Hooks& hooks)
{
    state_->checkAlive();
    // The negation also refuses a reach that is not a number.
    if (!(hooks.reach >= 0.0f) || hooks.shadowUniforms < 0)
        throw Error(ErrorKind::input, "hooks",
                    Found("a negative reach or number of uniforms").expected("0 or more"));
    discardHostErrors(*state_->device);
    state_->programs.check(hooks);
    return std::make_shared<GpuHooks>(std::make_shared<CompiledHooks>(state_->device, hooks));
}

std::shared_ptr<GpuLibrary> Renderer::createLibrary(const std::vector<Material>& materials,
                                                    const MaterialOptions& options)
{
    state_->checkAlive();
    discardHostErrors(*state_->device);
    return std::make_shared<GpuLibrary>(std::make_shared<LibraryResources>(
        state_->device, materials, options,
        [this](const MaterialResources& made) { state_->prepareFirst(made); }));
}

void Renderer::replaceMaterial(GpuLibrary& library, int index, const Material& material)
{
    state_->checkAlive();
    LibraryResources& resources = library.resources();
    if (resources.device() != state_->device.get())
        throw Error(ErrorKind::usage, "library",
                    Found("one of another renderer").expected("one of this"));
    if (index < 0 || static_cast<size_t>(index) >= resources.places().size())
        throw Error(ErrorKind::usage, "library",
                    Found("material " + std::to_string(index))
                        .expected("one of " + std::to_string(resources.places().size())));
    discardHostErrors(*state_->device);
    // The old one stays where GL refuses the new one: it is prepared before it takes the place.
    resources.replace(static_cast<size_t>(index), material,
                      [this](const MaterialResources& made) { state_->prepareFirst(made); });
}

void Renderer::prepare(const GpuMaterial& material, const DrawOptions& options, int lights)
{
    state_->checkAlive();
    state_->checkOwner(material.resources().device());
    state_->prepare(material.resources(), {}, options, lights);
}

void Renderer::prepare(const Item& item, const DrawOptions& options, int lights)
{
    state_->checkAlive();
    // Mesh and hooks decide on the text of the programs (tangents, hooks), so the item tells more
    // than its material.
    const Drawable drawable = state_->drawableOf(item);
    state_->prepare(drawable.material, drawable.surface, options, lights);
}

DrawStats Renderer::draw(const Target& target, const View& view, const std::vector<Item>& items,
                         const std::vector<Light>& lights, const DrawOptions& options)
{
    // All items share one guard: state is saved and restored once a call, not once an item.
    return state_->draw(target, view, lights, options,
                        [&](Executor& executor, const DrawRequest& request, DrawStats& stats) {
                            for (const Item& item : items)
                                state_->drawItem(executor, item, request, stats);
                        });
}

DrawStats Renderer::drawBatch(const Target& target, const View& view, const Batch& batch,
                              const std::vector<Light>& lights, const DrawOptions& options)
{
    return state_->draw(target, view, lights, options,
                        [&](Executor& executor, const DrawRequest& request, DrawStats& stats) {
                            state_->drawBatch(executor, batch, request, stats);
                        });
}

void Renderer::abandonContext() noexcept
{
    // Objects that outlive the context ask this flag before they delete a GL name (Object::reset).
    state_->device->alive = false;
}

}  // namespace fbrdf::gl

#include "RendererState.h"

#include <fbrdf/base/Found.h>

#include <algorithm>
#include <tuple>

namespace fbrdf::gl {
namespace {

const CompiledHooks* hooksOf(const Batch& batch)
{
    return batch.hooks ? &batch.hooks->compiled() : nullptr;
}

}  // namespace

void Renderer::State::checkBatch(const Batch& batch) const
{
    if (!batch.library || !batch.mesh)
        throw Error(ErrorKind::usage, "batch", Found("none").expected("a library and a mesh"));
    checkOwner(batch.library->resources().device());
    checkOwner(batch.mesh->resources().device());
    if (batch.hooks) checkOwner(batch.hooks->compiled().device());
}

/// The instances that can be drawn, for each group of materials.
std::vector<std::vector<const Instance*>> Renderer::State::sorted(const Batch& batch,
                                                                  DrawStats& stats)
{
    const LibraryResources& library = batch.library->resources();
    const auto& places = library.places();
    std::vector<std::vector<const Instance*>> result(library.groupCount());
    for (const Instance& instance : batch.instances)
        attempt(stats, 1, [&] {
            const auto index = static_cast<size_t>(instance.material);
            if (instance.material < 0 || index >= places.size())
                throw Error(ErrorKind::usage, "item",
                            Found("material " + std::to_string(instance.material))
                                .expected("one of " + std::to_string(places.size())));
            // An instance that cannot be drawn must not keep the others from being drawn.
            checkModel(instance.model);
            result[places[index].group].push_back(&instance);
        });
    return result;
}

/// Draws [first, last) in one call a pass.
void Renderer::State::drawPacked(Executor& executor, const Batch& batch,
                                 const MaterialResources& material, const Instance* const* first,
                                 const Instance* const* last, const DrawRequest& request,
                                 DrawStats& stats)
{
    std::vector<InstanceTexels> texels;
    std::vector<Sphere> bounds;
    const MeshResources& mesh = batch.mesh->resources();
    const CompiledHooks* const hooks = hooksOf(batch);
    // A vertex hook may move vertices as far as its reach.
    const Sphere meshBounds = reached(mesh.bounds(), hooks);
    for (const Instance* const* i = first; i != last; ++i) {
        const auto& place =
            batch.library->resources().places()[static_cast<size_t>((*i)->material)];
        texels.push_back(
            instanceTexels(modelView(request.view, (*i)->model), static_cast<int>(place.layer)));
        bounds.push_back(worldBounds(meshBounds, (*i)->model));
    }
    // The buffer is used again in the next call: GL orders the upload after the draw before it.
    instances.update(texels.size() * texels[0].size(), texels.size() * sizeof texels[0],
                     texels.data());
    draw(executor,
         {material,
          mesh,
          surfaceOptions(mesh, material, hooks, batch.normalMap),
          {},
          {instances.texture(), static_cast<int>(texels.size())}},
         enclosing(bounds), request, stats);
}

void Renderer::State::drawGroup(Executor& executor, const Batch& batch,
                                const MaterialResources& material,
                                const std::vector<const Instance*>& objects,
                                const DrawRequest& request, DrawStats& stats)
{
    // Materials whose tables differ in size cannot be layers of one array.
    if (!material.isPacked()) {
        for (const Instance* object : objects)
            attempt(stats, 1, [&] {
                const MeshResources& mesh = batch.mesh->resources();
                drawObject(executor,
                           {material,
                            mesh,
                            surfaceOptions(mesh, material, hooksOf(batch), batch.normalMap),
                            object->model,
                            {}},
                           request, stats);
            });
        return;
    }
    // A buffer texture has a largest size; more instances need more calls.
    const auto most = static_cast<size_t>(device->capabilities.maxBufferTexels) /
                      std::tuple_size_v<InstanceTexels>;
    for (size_t first = 0; first < objects.size(); first += most) {
        const size_t count = std::min(most, objects.size() - first);
        attempt(stats, static_cast<int>(count), [&] {
            drawPacked(executor, batch, material, &objects[first], &objects[first] + count, request,
                       stats);
        });
    }
}

void Renderer::State::drawBatch(Executor& executor, const Batch& batch, const DrawRequest& request,
                                DrawStats& stats)
{
    checkBatch(batch);
    const LibraryResources& library = batch.library->resources();
    if (!library.whyNotPacked().empty())
        device->logOnce(Severity::warning,
                        "objects of a library drawn one by one: " + library.whyNotPacked());
    const auto groups = sorted(batch, stats);
    for (size_t g = 0; g < groups.size(); ++g)
        drawGroup(executor, batch, library.group(g), groups[g], request, stats);
}

}  // namespace fbrdf::gl

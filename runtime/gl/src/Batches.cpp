#include "RendererState.h"

#include <algorithm>
#include <tuple>

namespace fbrdf::gl {

/// The instances that can be drawn, by the group that holds their material.
std::vector<std::vector<const Instance*>> Renderer::State::sorted(const Batch& batch,
                                                                  DrawStats& stats)
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
void Renderer::State::drawPacked(Executor& executor, const Batch& batch,
                                 const GpuMaterial& material, const Instance* const* first,
                                 const Instance* const* last, const DrawRequest& request,
                                 DrawStats& stats)
{
    std::vector<InstanceTexels> texels;
    std::vector<Sphere> bounds;
    const Sphere mesh = reached(batch.mesh->bounds(), batch.hooks);
    for (const Instance* const* i = first; i != last; ++i) {
        const auto& place = batch.library->places()[static_cast<size_t>((*i)->material)];
        texels.push_back(
            instanceTexels(modelView(request.view, (*i)->model), static_cast<int>(place.layer)));
        bounds.push_back(worldBounds(mesh, (*i)->model));
    }
    instances.update(texels.size() * texels[0].size(), texels.size() * sizeof texels[0],
                     texels.data());
    draw(executor,
         {material,
          *batch.mesh,
          surfaceOptions(*batch.mesh, material.form(), batch.hooks, batch.normalMap),
          {},
          {instances.texture(), static_cast<int>(texels.size())}},
         enclosing(bounds), request, stats);
}

void Renderer::State::drawGroup(Executor& executor, const Batch& batch, const GpuMaterial& material,
                                const std::vector<const Instance*>& objects,
                                const DrawRequest& request, DrawStats& stats)
{
    if (!material.isPacked()) {
        for (const Instance* object : objects)
            survive(stats, 1, [&] {
                drawItem(executor,
                         {&material, batch.mesh, object->model, batch.hooks, batch.normalMap},
                         request, stats);
            });
        return;
    }
    const auto most =
        static_cast<size_t>(device->maxBufferTexels) / std::tuple_size_v<InstanceTexels>;
    for (size_t first = 0; first < objects.size(); first += most) {
        const size_t count = std::min(most, objects.size() - first);
        survive(stats, static_cast<int>(count), [&] {
            drawPacked(executor, batch, material, &objects[first], &objects[first] + count, request,
                       stats);
        });
    }
}

void Renderer::State::drawBatch(Executor& executor, const Batch& batch, const DrawRequest& request,
                                DrawStats& stats)
{
    checkOwners(batch.library, batch.mesh, batch.hooks);
    if (!batch.library->reason().empty())
        device->logOnce(Severity::warning,
                        "objects of a library drawn one by one: " + batch.library->reason());
    const auto groups = sorted(batch, stats);
    for (size_t g = 0; g < groups.size(); ++g)
        drawGroup(executor, batch, batch.library->group(g), groups[g], request, stats);
}

}  // namespace fbrdf::gl

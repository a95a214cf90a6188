// Lists of lights of a draw: whether there are any, who makes them, and where they are uploaded.
#include "RendererState.h"

#include <fbrdf/base/Found.h>

namespace fbrdf::gl {
namespace {

constexpr size_t kFewLights = 8, kFewAreaLights = 2;

std::string noLists()
{
    return Found("lists of lights asked for")
        .expected("OpenGL 3.1, technique single and no limit of look-ups");
}

}  // namespace

bool Renderer::State::hasLists(const DrawOptions& options, size_t lights)
{
    return isClustered(options, lights, kFewLights);
}

bool Renderer::State::hasAreaLists(const DrawOptions& options, size_t lights)
{
    return isClustered(options, lights, kFewAreaLights);
}

bool Renderer::State::isClustered(const DrawOptions& options, size_t lights, size_t few)
{
    // A fragment finds out for itself which of a few lights reach it, sooner than it finds a list.
    if (!options.clustered || lights <= few) return false;
    const bool possible = options.technique == Technique::single && options.maxLookups == 0 &&
                          device->capabilities.bufferTextures;
    if (!possible) device->logOnce(Severity::warning, noLists() + ": drawing without");
    return possible;
}

void Renderer::State::cluster(DrawRequest& request, DrawStats& stats)
{
    if (!hasLists(request.options, request.lights.size())) {
        if (request.options.clustered && request.lights.size() > kFewLights)
            stats.whyReplaced = noLists();
        return;
    }
    makeLists(
        request, request.eye.vectors, clusterBuilder, clusterBuffers,
        [&](bool isNew) {
            return clusterBuffers.updateLights(clusterBuilder.clusters(), request.eye.numbers,
                                               isNew);
        },
        stats);
    request.clusters = &clusterBuilder.clusters();
}

void Renderer::State::clusterAreas(DrawRequest& request, DrawStats& stats)
{
    if (!hasAreaLists(request.options, request.eye.areas.size())) return;
    std::vector<LightVectors> reaches;
    for (const AreaVectors& area : request.eye.areas) reaches.push_back(reachOf(area));
    makeLists(
        request, reaches, areaBuilder, areaBuffers,
        [&](bool isNew) {
            return areaBuffers.updateAreas(areaBuilder.clusters(), request.eye.areas, isNew);
        },
        stats);
    request.areaClusters = &areaBuilder.clusters();
}

std::string Renderer::State::whyListsByCpu(const DrawOptions& options)
{
    if (options.listsBy == ListsBy::cpu) return "asked for";
    // A CPU that runs the shader takes longer than one that makes the lists (docs/benchmarks.md).
    if (options.listsBy == ListsBy::automatic && device->capabilities.softwareSampling)
        return Found("a renderer in software").expected("a GPU");
    if (options.maxLights > 0)
        return Found("a limit of " + std::to_string(options.maxLights) + " lights")
            .expected("none");
    return listKernel.whyNot();
}

void Renderer::State::makeLists(const DrawRequest& request, const std::vector<LightVectors>& lights,
                                ClusterBuilder& builder, ClusterBuffers& buffers,
                                const std::function<bool(bool isNew)>& upload, DrawStats& stats)
{
    const glm::dmat4 projection(request.view.projection);
    std::string why = whyListsByCpu(request.options);
    if (why.empty()) {
        const bool isNew = builder.updateWork(lights, projection);
        why = listKernel.whyTooMany(builder.work());
        if (why.empty()) try {
                if (upload(isNew)) listKernel.make(builder.clusters(), builder.work(), buffers);
                buffers.finish();
            } catch (const Error& error) {
                buffers.forget();
                why = error.what();
            }
    }
    stats.listsBy = why.empty() ? ListsBy::gpu : ListsBy::cpu;
    if (why.empty()) return;
    stats.whyListsByCpu = why;
    if (request.options.listsBy == ListsBy::gpu)
        device->logOnce(Severity::warning, "lists of lights are made by the CPU: " + why);
    const bool isNew = builder.update(lights, projection, {}, request.options.maxLights);
    stats.lightsDropped += builder.clusters().dropped;
    // Where nothing has moved, nothing has to be uploaded.
    if (upload(isNew)) buffers.uploadLists(builder.clusters());
}

}  // namespace fbrdf::gl

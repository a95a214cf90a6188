// RendererState.h - what a renderer keeps between calls, and how it draws: one item
// (RendererState.cpp), the objects of a batch (Batches.cpp).
#pragma once
#include "DrawRequest.h"
#include "GpuLibrary.h"

#include <fbrdf/base/Error.h>

namespace fbrdf::gl {

struct Renderer::State {
    DevicePtr device;
    ProgramCache programs;
    Surfaces surfaces;
    ClusterBuffers clusterBuffers;
    BufferTexture instances;

    explicit State(const DevicePtr& device);

    void checkAlive() const;
    /// source: what materials come from.
    template <class Source>
    void checkOwners(const Source* source, const GpuMesh* mesh, const GpuHooks* hooks) const;
    PlanRequest request(const DrawOptions& options, int lights, const TargetInfo& target) const;
    std::vector<const Program*> programsOf(const GpuMaterial& material,
                                           const SurfaceOptions& surface, const Plan& plan,
                                           bool clustered);
    /// Returns the plan asked for or, with a warning, the one that takes all lights in one pass.
    /// draw: its target's surfaces are made ready; may be null.
    Plan planFor(const GpuMaterial& material, const GpuHooks* hooks, PlanRequest wanted,
                 const DrawRequest* draw, std::string& whyReplaced);
    /// Builds what a draw will need.
    void prepare(const GpuMaterial& material, const SurfaceOptions& surface,
                 const DrawOptions& options, int lights);
    /// Whether lights go into lists: asked for, possible, and there are any.
    bool isClustered(const DrawOptions& options, size_t lights);

    /// Sets everything up for a draw, then drawAll(executor, request, stats).
    using DrawAll = std::function<void(Executor&, const DrawRequest&, DrawStats&)>;
    DrawStats draw(const Target& target, const View& view, const std::vector<Light>& lights,
                   const DrawOptions& options, const DrawAll& drawAll);
    void drawItem(Executor& executor, const Item& item, const DrawRequest& request,
                  DrawStats& stats);
    void drawBatch(Executor& executor, const Batch& batch, const DrawRequest& request,
                   DrawStats& stats);

private:
    void draw(Executor& executor, const Drawable& item, const Sphere& bounds,
              const DrawRequest& draw, DrawStats& stats);
    void cluster(DrawRequest& request, LightClusters& clusters, Frame& frame, DrawStats& stats);
    std::vector<std::vector<const Instance*>> sorted(const Batch& batch, DrawStats& stats);
    void drawPacked(Executor& executor, const Batch& batch, const GpuMaterial& material,
                    const Instance* const* first, const Instance* const* last,
                    const DrawRequest& request, DrawStats& stats);
    void drawGroup(Executor& executor, const Batch& batch, const GpuMaterial& material,
                   const std::vector<const Instance*>& objects, const DrawRequest& request,
                   DrawStats& stats);
    template <class Draw>
    void survive(DrawStats& stats, int objects, Draw drawIt);
};

void checkModel(const glm::mat4& model);

template <class Source>
void Renderer::State::checkOwners(const Source* source, const GpuMesh* mesh,
                                  const GpuHooks* hooks) const
{
    if (!source || !mesh)
        throw Error(ErrorKind::usage, "item", "found none, expected a material and a mesh");
    if (source->device() != device.get() || mesh->device() != device.get() ||
        (hooks && hooks->device() != device.get()))
        throw Error(ErrorKind::usage, "item",
                    "found a material, mesh or hooks of another renderer, expected those of this");
}

/// What fails is left out, logged and counted.
template <class Draw>
void Renderer::State::survive(DrawStats& stats, int objects, Draw drawIt)
{
    try {
        drawIt();
    } catch (const Error& error) {
        stats.itemsFailed += objects;
        device->logOnce(Severity::error, error.what());
    }
}

}  // namespace fbrdf::gl

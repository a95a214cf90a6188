// RendererState.h - what a renderer keeps between calls, and how it draws an item
// (RendererState.cpp) or the objects of a batch (Batches.cpp).
//
// Renderer, State, DrawRequest and Executor differ in how long they live: Renderer is the door,
// whose header shows no GL; State lasts as long as it; a DrawRequest is one call; an Executor has
// the bindings of one call, so that items which follow each other bind nothing twice.
#pragma once
#include "Executor.h"
#include "LibraryResources.h"
#include "ListKernel.h"

#include <fbrdf/base/Error.h>

namespace fbrdf::gl {

/// What became of what was asked for; empty where it is drawn.
struct PlanNotes {
    std::string whyReplaced, whyNoEnvironment, whyNotSampled;
};

struct Renderer::State {
    DevicePtr device;
    ProgramCache programs;
    SurfacePool surfaces;
    ClusterBuilder clusterBuilder, areaBuilder;
    ClusterBuffers clusterBuffers, areaBuffers;
    ListKernel listKernel;
    BufferTexture instances;
    Workers workers;

    State(const DevicePtr& device, const RendererOptions& options);

    void checkAlive() const;
    /// Throws Error(usage) for an object of another renderer.
    void checkOwner(const Device* owner) const;
    /// Throws Error(usage) for an item that is not whole or not of this renderer.
    Drawable drawableOf(const Item& item) const;
    PlanRequest request(const DrawOptions& options, int lights, const TargetInfo& target) const;
    std::vector<const Program*> programsOf(const MaterialResources& material,
                                           const SurfaceOptions& surface, const Plan& plan,
                                           bool clustered, bool areaLists);
    /// Returns the plan asked for or, with a warning, the one that takes all lights in one pass.
    /// draw: whose target gets surfaces where the plan needs them; may be null. The programs are
    /// left to programsOf.
    ReadyPlan planFor(const MaterialResources& material, const CompiledHooks* hooks,
                      PlanRequest wanted, const DrawRequest* draw, PlanNotes& notes);
    /// Builds what every material needs, and so refuses one that GL cannot draw.
    void prepareFirst(const MaterialResources& material);
    /// Builds what a draw will need.
    void prepare(const MaterialResources& material, const SurfaceOptions& surface,
                 const DrawOptions& options, int lights);
    /// True where lists of lights were asked for and are possible, and there are more than a few.
    bool hasLists(const DrawOptions& options, size_t lights);
    bool hasAreaLists(const DrawOptions& options, size_t lights);  ///< the same of area lights

    /// Sets everything up for a draw, then calls drawAll(executor, request, stats).
    using DrawAll = std::function<void(Executor&, const DrawRequest&, DrawStats&)>;
    DrawStats draw(const Target& target, const View& view, const std::vector<Light>& lights,
                   const DrawOptions& options, const DrawAll& drawAll);
    void drawItem(Executor& executor, const Item& item, const DrawRequest& request,
                  DrawStats& stats);
    /// Draws one object, culling lights by the bounds of its mesh.
    void drawObject(Executor& executor, const Drawable& object, const DrawRequest& request,
                    DrawStats& stats);
    void drawBatch(Executor& executor, const Batch& batch, const DrawRequest& request,
                   DrawStats& stats);

private:
    bool isClustered(const DrawOptions& options, size_t lights, size_t few);
    /// The plan with directions of an environment, where such a plan is wanted and possible; else
    /// none, with the reason.
    ReadyPlan sampledPlan(const MaterialResources& material, PlanRequest& wanted,
                          const Capabilities& capabilities, const DrawRequest* draw,
                          PlanNotes& notes);
    /// The plan and its surfaces; where those cannot be made, a plan without.
    ReadyPlan planOf(const Form& form, PlanRequest& wanted, const Capabilities& capabilities,
                     const DrawRequest* draw);
    void draw(Executor& executor, const Drawable& item, const Sphere& bounds,
              const DrawRequest& draw, DrawStats& stats);
    void cluster(DrawRequest& request, DrawStats& stats);
    void clusterAreas(DrawRequest& request, DrawStats& stats);
    /// Why the CPU makes the lists of a draw; "" where the GPU does.
    std::string whyListsByCpu(const DrawOptions& options);
    /// Makes lists by the one or the other, and says by which. upload(isNew) uploads what they are
    /// of, and returns whether lists are needed.
    void makeLists(const DrawRequest& request, const std::vector<LightVectors>& lights,
                   ClusterBuilder& builder, ClusterBuffers& buffers,
                   const std::function<bool(bool isNew)>& upload, DrawStats& stats);
    void leaveEnvironmentOut(const MaterialResources& material, const std::string& why, int objects,
                             DrawStats& stats);
    std::vector<std::vector<const Instance*>> sorted(const Batch& batch, DrawStats& stats);
    void drawPacked(Executor& executor, const Batch& batch, const MaterialResources& material,
                    const Instance* const* first, const Instance* const* last,
                    const DrawRequest& request, DrawStats& stats);
    void drawGroup(Executor& executor, const Batch& batch, const MaterialResources& material,
                   const std::vector<const Instance*>& objects, const DrawRequest& request,
                   DrawStats& stats);
    void checkBatch(const Batch& batch) const;
    template <class Draw>
    void attempt(DrawStats& stats, int objects, Draw drawIt);
};

void checkModel(const glm::mat4& model);

/// Draws `objects` objects; where that fails, they are left out, logged and counted.
template <class Draw>
void Renderer::State::attempt(DrawStats& stats, int objects, Draw drawIt)
{
    try {
        drawIt();
    } catch (const Error& error) {
        stats.itemsFailed += objects;
        device->logOnce(Severity::error, error.what());
    }
}

}  // namespace fbrdf::gl

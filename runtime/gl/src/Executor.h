// Executor.h - carries out a plan for one item, or for the instances of a batch.
#pragma once
#include "ClusterBuffers.h"
#include "DrawRequest.h"
#include "Instances.h"
#include "MeshResources.h"
#include "ProgramCache.h"
#include "StateGuard.h"
#include "SurfacePool.h"

#include <glm/mat3x3.hpp>

#include <array>

namespace fbrdf::gl {

/// What one plan draws.
struct Drawable {
    const MaterialResources& material;
    const MeshResources& mesh;
    SurfaceOptions surface;
    glm::mat4 model{1.0f};  ///< where there are no instances
    struct {
        GLuint texture = 0;  ///< fbrdfInstances
        int count = 0;       ///< 0: one, placed by `model`
    } instances{};
};

/// A plan with what it needs.
struct ReadyPlan {
    Plan plan;
    const Surfaces* surfaces = nullptr;    ///< where a pass writes any but the target
    std::vector<const Program*> programs;  ///< one for each pass
    const LobeTable* lobes = nullptr;      ///< where a pass adds lobes
};

class Executor {
public:
    /// lists, areaLists: of lights and area lights, where the request has them.
    Executor(const Device& device, const DrawRequest& request, const ClusterBuffers& lists,
             const ClusterBuffers& areaLists, StateGuard& state)
        : device_(device),
          gl_(device.gl),
          request_(request),
          lists_(lists),
          areaLists_(areaLists),
          state_(state)
    {
    }

    /// lights: of this item, as the plan counts them; unused where they are in lists. Returns the
    /// look-ups of the most expensive pass.
    int draw(const Drawable& item, const ReadyPlan& ready, const EyeLights& lights);

private:
    void bindSurface(const Pass& pass);
    void clearSurface(const Pass& pass);
    void resolveRead(const Pass& pass);
    void setDepth(Depth depth);
    void useProgram(const Drawable& item, const Program& program);
    void setMatrices(const Drawable& item, const Program& program);
    void bindTables(const MaterialResources& material, const Program& program);
    void setLights(const Pass& pass, const Program& program);
    void setClusters(const Program::ClusterUniforms& uniforms, const LightClusters& clusters,
                     const ClusterBuffers& buffers);
    void setEnvironment(const MaterialResources& material, const Program& program);
    void setLobes(const LobeTable& table, const Pass& pass, const Program& program);
    void setAreaLights(const Pass& pass, const Program& program);
    void setScissor(const Pass& pass);
    int lightsOf(const Pass& pass, const Program& program) const;

    const Device& device_;
    const Functions& gl_;
    const DrawRequest& request_;
    const ClusterBuffers &lists_, &areaLists_;
    StateGuard& state_;
    const Surfaces* surfaces_ = nullptr;  ///< of the plan
    bool depthCleared_ = false;           ///< of the surfaces, for this item
    /// Of the surfaces, by Surface: drawn to for this item; and since its mean was taken.
    std::array<bool, 4> written_{}, changed_{};
    const EyeLights* lights_ = nullptr;  ///< of the item
    const Program* program_ = nullptr;   ///< in use, with the item's uniforms set
};

}  // namespace fbrdf::gl

// Executor.h - carries out a plan for one item, or for the instances of a batch.
#pragma once
#include "ClusterBuffers.h"
#include "Instances.h"
#include "MeshResources.h"
#include "Program.h"
#include "StateGuard.h"
#include "Surfaces.h"

#include <fbrdf/plan/LightVectors.h>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

namespace fbrdf::gl {

/// Lights in eye space as the shader takes them.
struct EyeLights {
    std::vector<LightVectors> vectors;
    std::vector<int32_t> numbers;  ///< places among the lights that draw() was given
    std::vector<double> peaks;     ///< largestIrradiance on an item
};

/// What all items of one draw share.
struct Frame {
    Target target;
    View view;
    glm::vec4 eye{0.0f};
    const LightClusters* clusters = nullptr;  ///< where lights are in lists
    const ClusterBuffers* clusterBuffers = nullptr;
};

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

class Executor {
public:
    Executor(const Device& device, const Frame& frame, const Surfaces& surfaces, StateGuard& state)
        : device_(device), gl_(device.gl), frame_(frame), surfaces_(surfaces), state_(state)
    {
    }

    /// programs: one for each pass. lights: of this item, as the plan counts them; unused where
    /// they are in lists. Returns the look-ups of the most expensive pass.
    int draw(const Drawable& item, const Plan& plan, const std::vector<const Program*>& programs,
             const EyeLights& lights);

private:
    void bindSurface(const Pass& pass);
    void setBlend(Blend blend);
    void setDepth(Depth depth);
    void useProgram(const Drawable& item, const Program& program);
    void setMatrices(const Drawable& item, const Program& program);
    void bindTables(const MaterialResources& material, const Program& program);
    void setLights(const Pass& pass, const Program& program);
    void setClusters(const Program& program);
    void setScissor(const Pass& pass);
    int lightsOf(const Pass& pass, const Program& program) const;

    const Device& device_;
    const Functions& gl_;
    const Frame& frame_;
    const Surfaces& surfaces_;
    StateGuard& state_;
    const EyeLights* lights_ = nullptr;  ///< of the item
    const Program* program_ = nullptr;   ///< in use, with the item's uniforms set
};

}  // namespace fbrdf::gl

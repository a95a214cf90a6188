// DrawRequest.h - what one call of Renderer::draw or drawBatch is about, checked.
#pragma once
#include "TargetInfo.h"

#include <fbrdf/plan/LightSelection.h>
#include <fbrdf/plan/LightVectors.h>

namespace fbrdf::gl {

/// What one call of draw() is about.
struct DrawRequest {
    const Target& target;
    const View& view;
    const DrawOptions& options;
    TargetInfo info;
    std::vector<Light> lights;          ///< the valid ones, exposed
    std::vector<LightVectors> vectors;  ///< of each, in eye space
    bool clustered = false;
};

/// Throws Error(gl) for a target that cannot be drawn to, Error(usage) for such a view.
void checkRequest(const Device& device, const Target& target, const View& view);
bool isInvertible(const glm::mat4& model);
/// The valid ones, exposed: light is linear, so that is where exposure costs nothing.
std::vector<Light> usableLights(const std::vector<Light>& lights, const Target& target);

Sphere worldBounds(const GpuMesh& mesh, const glm::mat4& model);
Sphere enclosing(const std::vector<Sphere>& spheres);

}  // namespace fbrdf::gl

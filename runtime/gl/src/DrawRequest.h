// DrawRequest.h - what one call of Renderer::draw or drawBatch is about, checked.
#pragma once
#include "Executor.h"
#include "TargetInfo.h"

#include <fbrdf/plan/LightSelection.h>

namespace fbrdf::gl {

/// What one call of draw() is about.
struct DrawRequest {
    const Target& target;
    const View& view;
    const DrawOptions& options;
    TargetInfo info;
    std::vector<Light> lights;  ///< the valid ones, exposed: light is linear, so that is where
                                ///< exposure costs nothing
    EyeLights eye;              ///< of each
    bool clustered = false;
};

/// Throws Error(gl) for a target that cannot be drawn to, Error(usage) for such a view.
void checkRequest(const Device& device, const Target& target, const View& view);
bool isInvertible(const glm::mat4& model);
/// Fills in lights and eye from those that are valid.
void setLights(DrawRequest& request, const std::vector<Light>& lights);
/// All lights that reach the bounds, or the strongest of them; counts the others.
EyeLights lightsOf(const Sphere& bounds, const DrawRequest& request, DrawStats& stats);

/// In an order in which lights that reach the same pixels follow each other: batches of them are
/// scissored.
void putNeighboursTogether(EyeLights& lights, const DrawRequest& request);

/// bounds: object space.
Sphere worldBounds(const Sphere& bounds, const glm::mat4& model);
Sphere enclosing(const std::vector<Sphere>& spheres);

}  // namespace fbrdf::gl

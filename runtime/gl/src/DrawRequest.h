// DrawRequest.h - what one call of Renderer::draw or drawBatch is about, checked.
#pragma once
#include "EnvironmentResources.h"
#include "TargetInfo.h"

#include <fbrdf/base/Workers.h>
#include <fbrdf/plan/AreaVectors.h>
#include <fbrdf/plan/LightClusters.h>
#include <fbrdf/plan/LightSelection.h>
#include <fbrdf/plan/LightVectors.h>

#include <glm/mat3x3.hpp>
#include <glm/vec4.hpp>

#include <optional>

namespace fbrdf::gl {

/// Lights in eye space as the shader takes them; the first three arrays are parallel.
struct EyeLights {
    std::vector<LightVectors> vectors;
    std::vector<int32_t> numbers;  ///< places among the lights that draw() was given
    std::vector<double> peaks;     ///< largestIrradiance on the item; may be empty
    std::vector<AreaVectors> areas = {};
};

/// Light from everywhere as the shader takes it.
struct EyeEnvironment {
    const EnvironmentResources* map = nullptr;  ///< null: there is none, or it is black
    glm::mat3 fromEye{1.0f};                    ///< eye space to that of the environment
    glm::vec4 scale{0.0f};                      ///< fbrdfEnvironmentScale
    int lobes = 0, samples = 0;                 ///< as EnvironmentLight
};

/// What one call of draw() is about, and all of its items share.
struct DrawRequest {
    const Target& target;
    const View& view;
    const DrawOptions& options;
    TargetInfo info;
    /// The valid ones. Their intensities are multiplied by the exposure: radiance is linear in
    /// them, so there it costs nothing.
    std::vector<Light> lights;
    EyeLights eye;                      ///< the same lights in eye space
    std::vector<AreaLight> areaLights;  ///< the valid ones, exposed as the lights
    /// eye.areas of area light i: from the i-th of these to the next.
    std::vector<size_t> firstAreas;
    /// Null where lights, or area lights, are not in lists.
    const LightClusters *clusters = nullptr, *areaClusters = nullptr;
    /// The eye as the shader takes it: see eyeFromProjection.
    glm::vec4 eyePoint{0.0f};
    EyeEnvironment environment = {};
};

/// Throws Error(gl) for a target that cannot be drawn to, Error(usage) for such a view.
void checkRequest(const Device& device, const Target& target, const View& view);
bool isInvertible(const glm::mat4& model);
/// Fills in lights and eye from those that are valid.
void setLights(DrawRequest& request, const std::vector<Light>& lights, Workers& workers);
/// The same for the area lights of the options. lights: the number of those that the draw was given
/// beside them. What is wrong with one is logged.
void setAreaLights(DrawRequest& request, Device& device, int lights);
/// Fills in the environment. Throws Error(usage) for one of another renderer, a rotation that is
/// none, or an intensity that is negative or not finite.
void setEnvironment(DrawRequest& request, const Device& device);
/// Returns the lights that reach the bounds, or the strongest of them, and counts the others.
EyeLights lightsOf(const Sphere& bounds, const DrawRequest& request, DrawStats& stats);
/// The same for area lights.
std::vector<AreaVectors> areasOf(const Sphere& bounds, const DrawRequest& request,
                                 DrawStats& stats);

/// Sorts lights so that those that reach the same pixels follow each other: the scissor of a batch
/// of lights is then small.
void putNeighboursTogether(EyeLights& lights, const DrawRequest& request);

/// Bounds of an object in world space. bounds: in object space.
Sphere worldBounds(const Sphere& bounds, const glm::mat4& model);
Sphere enclosing(const std::vector<Sphere>& spheres);

}  // namespace fbrdf::gl

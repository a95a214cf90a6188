// PlanRequests.h - what tests of plans ask for.
#pragma once
#include <fbrdf/plan/Plan.h>

namespace fbrdf {

// The rounding of at most 300 positive products that are added up in another order.
constexpr double kRounding = 1e-12;

inline Capabilities modern()
{
    Capabilities c;
    c.glsl = 330;
    c.maxUniformVectors = 4096;
    c.framebufferObjects = c.floatTextures = c.floatTargets = c.vertexArrays = true;
    return c;
}

inline PlanRequest twoLookup(int lights)
{
    PlanRequest request;
    request.technique = Technique::twoLookup;
    request.lights = lights;
    return request;
}

/// The lobes of a material as the fitter makes them.
inline LobeLayout tiltedLobes(int lobes)
{
    return {LobeAxes::tilted, lobes, 24, 1};
}

inline LobeLayout bentLobes(int lobes)
{
    return {LobeAxes::bent, lobes, 12, 7};
}

}  // namespace fbrdf

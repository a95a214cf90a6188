// ViewLights.h - the lights of a renderer in the coordinates of its view, as the runtime takes
// them.
#pragma once
#include <fbrdf/plan/LightVectors.h>

#include <glm/vec4.hpp>

#include <vector>

class vtkOpenGLRenderer;

namespace fbrdf::vtk {

/// VTK's attenuation is not 1 / r^2 but 1 / (constant + linear r + quadratic r^2), and its cones
/// have an exponent: the first `attenuations.size()` lights have such.
struct ViewLights {
    std::vector<LightVectors> lights;
    std::vector<glm::vec4> attenuations;  ///< constant, linear, quadratic, exponent
    int dropped = 0;                      ///< lights that are on but not finite
};

/// Of the lights that are on.
ViewLights viewLights(vtkOpenGLRenderer& renderer);

/// When they last changed: the renderer's lights, its camera and how it moves lights.
unsigned long long lightsTime(vtkOpenGLRenderer& renderer);

}  // namespace fbrdf::vtk

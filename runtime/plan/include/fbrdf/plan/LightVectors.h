// LightVectors.h - a light as every program takes it (lights.glsl): three vec4 in eye space,
//   (position, or for a directional light the unit direction towards it; 1 / radius^2, 0 for an
//   unlimited light): all that says which points it reaches
//   (intensity; 1, or for a directional light 0)
//   (unit axis x scale, offset) of its cone (Light.h), (0, 0, 0, 1) where there is none
// Pure; renderers and engine plugins share it.
#pragma once
#include <fbrdf/plan/Light.h>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace fbrdf {

constexpr int kVectorsPerLight = 3;
using LightVectors = std::array<glm::vec4, kVectorsPerLight>;

/// light: valid (isValid). toEye: world to eye, rigid; identity where lights are in eye space.
/// Computed in double.
LightVectors lightVectors(const Light& light, const glm::dmat4& toEye);

}  // namespace fbrdf

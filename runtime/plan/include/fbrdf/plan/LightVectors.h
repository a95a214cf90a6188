// LightVectors.h - a light as every program takes it (lights.glsl): three vec4 in eye space,
//   [0]  position, or for a directional light the unit direction towards it; w: 1 / radius^2, or 0
//        for an unlimited light. This vector alone decides which points the light reaches.
//   [1]  intensity; w: 1, or 0 for a directional light
//   [2]  unit axis times the scale of its cone; w: the offset of the cone (Light.h). A light
//        without a cone has (0, 0, 0, 1).
// Pure; renderers and engine plugins share it.
#pragma once
#include <fbrdf/plan/Light.h>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace fbrdf {

constexpr int kVectorsPerLight = 3;
using LightVectors = std::array<glm::vec4, kVectorsPerLight>;

/// Expects isValid(light). toEye: world to eye, rigid; identity where lights are in eye space.
/// Computed in double.
LightVectors lightVectors(const Light& light, const glm::dmat4& toEye);

}  // namespace fbrdf

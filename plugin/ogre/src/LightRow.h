// LightRow.h - a light of OGRE as the shader reads it: a row of four texels (ogre_lights.glsl).
#pragma once
#include <OgreLight.h>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace ogreFbrdf {

constexpr int kTexelsPerLight = 4;
using LightRow = std::array<glm::vec4, kTexelsPerLight>;

/// OGRE's diffuse colour is what a white diffuse surface shows, so the irradiance is pi times that,
/// as for osg::Lights. toEye: world to eye. A light with a number that is not finite is black.
LightRow lightRow(const Ogre::Light& light, const glm::dmat4& toEye);

}  // namespace ogreFbrdf

// Instances.h - where the objects of a batch stand, as surface.vert reads them.
#pragma once
#include <fbrdf/gl/Renderer.h>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace fbrdf::gl {

/// Products in double: model and view may cancel large translations.
glm::mat4 modelView(const View& view, const glm::mat4& model);

/// Four texels of fbrdfInstances. layer: that of the packed material, below 2^24, up to which a
/// float represents every integer.
using InstanceTexels = std::array<glm::vec4, 4>;
InstanceTexels instanceTexels(const glm::mat4& modelView, int layer);

}  // namespace fbrdf::gl

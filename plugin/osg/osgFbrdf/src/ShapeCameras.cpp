#include "ShapeCameras.h"

#include <osg/Camera>

#include <algorithm>

namespace osgFbrdf {
namespace {

bool isColour(osg::Camera::BufferComponent component)
{
    return component == osg::Camera::COLOR_BUFFER || component >= osg::Camera::COLOR_BUFFER0;
}

bool overridesMaterials(const osg::Camera& camera)
{
    const osg::StateSet* state = camera.getStateSet();
    const auto* material = state ? state->getAttributePair(osg::StateAttribute::MATERIAL) : nullptr;
    return material && (material->second & osg::StateAttribute::OVERRIDE);
}

}  // namespace

bool drawsShapes(const osg::Camera& camera)
{
    const auto& targets = camera.getBufferAttachmentMap();
    if (targets.empty()) return false;
    return overridesMaterials(camera) ||
           std::none_of(targets.begin(), targets.end(),
                        [](const auto& target) { return isColour(target.first); });
}

}  // namespace osgFbrdf

// ShapeCameras.h - recognises cameras that need to know where an object is and not how it looks, as
// those of shadow maps do. They draw the children of an effect as they are, in one pass.
#pragma once

namespace osg {
class Camera;
}

namespace osgFbrdf {

/// True for a camera that draws to textures of its own and to no colour among them, or that puts an
/// osg::Material over all that is below it, as osgShadow::ShadowTexture does for silhouettes.
bool drawsShapes(const osg::Camera& camera);

}  // namespace osgFbrdf

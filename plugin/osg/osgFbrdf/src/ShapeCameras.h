// ShapeCameras.h - cameras that want to know where an object is, not how it looks: those of shadow
// maps. In them the children of an effect are drawn as they are, in one pass.
#pragma once

namespace osg {
class Camera;
}

namespace osgFbrdf {

/// True for a camera that draws to textures of its own, of which none is a colour, or that puts an
/// osg::Material over all that is below it (osgShadow::ShadowTexture, for silhouettes).
bool drawsShapes(const osg::Camera& camera);

}  // namespace osgFbrdf

// SceneLights.h - the lights of a scene graph, wherever they are in it.
#pragma once
#include "OsgLights.h"

#include <osg/Node>

#include <vector>

namespace osgUtil {
class CullVisitor;
}

namespace osgFbrdf {

struct SceneLights {
    std::vector<fbrdf::Light> lights;     ///< the valid ones of PointLights, in world coordinates
    std::vector<PlacedOsgLight> sources;  ///< of osg::LightSources, or else the light of the view
    int viewNumber = -1;  ///< OpenGL's number for the light of the osg::View; -1: it has none
    int dropped = 0;      ///< lights of PointLights that are not valid
};

/// Where the coordinates of the lights begin: the node below the last camera of the path that has a
/// view of its own. path: not empty.
osg::Node& rootOfLights(const osg::NodePath& path);

/// The lights below the root that the visitor sees: its cull mask and levels of detail count.
SceneLights lightsBelow(osg::Node& root, osgUtil::CullVisitor& visitor);

/// The matrix from the coordinates of the lights to those of the eye.
osg::Matrixd worldToEye(osgUtil::CullVisitor& visitor);

/// The light where the matrix, which is rigid, takes it.
fbrdf::Light moved(fbrdf::Light light, const osg::Matrixd& matrix);

}  // namespace osgFbrdf

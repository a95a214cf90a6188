// SceneLights.h - the lights of a scene graph and its environment, wherever they are in it.
#pragma once
#include "EnvironmentCube.h"
#include "OsgLights.h"

#include <fbrdf/plan/AreaLight.h>

#include <osg/Node>

#include <optional>
#include <vector>

namespace osgUtil {
class CullVisitor;
}

namespace osgFbrdf {

class PointLights;

/// The first EnvironmentLight of the scene.
struct SceneEnvironment {
    osg::ref_ptr<EnvironmentCube> cube;  ///< null: there is none
    osg::Matrixd toWorld;                ///< from directions of the panorama
    osg::Vec3f intensity;
    int lobes = 0;    ///< at most so many of a material; 0: all
    int leftOut = 0;  ///< other environments of the scene
};

/// A node of PointLights as it was when its lights were collected.
struct PlacedPointLights {
    const PointLights* node = nullptr;
    unsigned int version = 0;
    osg::Matrixd toWorld;
    bool operator==(const PlacedPointLights& other) const
    {
        return node == other.node && version == other.version && toWorld == other.toWorld;
    }
};

struct SceneLights {
    std::vector<fbrdf::Light> lights;  ///< the valid ones of PointLights, in world coordinates
    unsigned int serial = 0;           ///< another number wherever `lights` are others
    std::vector<PlacedPointLights> pointLights;  ///< that they come from
    int pointLightsDropped = 0;
    std::vector<fbrdf::AreaLight> areaLights;  ///< those of AreaLights, in the same coordinates
    std::vector<PlacedOsgLight> sources;  ///< of osg::LightSources, or else the light of the view
    SceneEnvironment environment;
    /// The light of the view, where nothing but an environment or area lights light the scene: for
    /// objects that can have neither.
    std::optional<PlacedOsgLight> spare;
    int viewNumber = -1;     ///< OpenGL's number for the light of the osg::View; -1: it has none
    int dropped = 0;         ///< lights of PointLights and AreaLights that are not valid
    std::string whyInvalid;  ///< why the last of them is not; empty: it is a point light
};

/// The mean radiance of all directions.
osg::Vec3f meanOf(const SceneEnvironment& environment);

/// Where the coordinates of the lights begin: the node below the last camera of the path that has a
/// view of its own. path: not empty.
osg::Node& rootOfLights(const osg::NodePath& path);

/// The lights and the environment below the root that the visitor sees: its cull mask and levels of
/// detail count. last: what was collected before, whose lights are taken over where all PointLights
/// are the same.
SceneLights lightsBelow(osg::Node& root, osgUtil::CullVisitor& visitor, SceneLights&& last);

/// The matrix from the coordinates of the lights to those of the eye.
osg::Matrixd worldToEye(osgUtil::CullVisitor& visitor);

/// The light where the matrix, which is rigid, takes it.
fbrdf::Light moved(fbrdf::Light light, const osg::Matrixd& matrix);
/// The same, where the matrix may scale and mirror too (AreaLights.h).
fbrdf::AreaLight moved(fbrdf::AreaLight light, const osg::Matrixd& matrix);

}  // namespace osgFbrdf

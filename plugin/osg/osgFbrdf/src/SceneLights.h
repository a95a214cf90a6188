// SceneLights.h - the lights that a cull traversal sees, found once a frame and view.
//
// The lights may come after the objects in the graph, and the number of passes depends on the
// number of lights, so OSG's own road for positional state (known when drawing begins) is too late.
// They are kept with the CullVisitor, which belongs to one view and one thread at a time: nothing
// is shared.
#pragma once
#include "PlainLights.h"

#include <fbrdf/plan/LightSelection.h>

#include <osg/Object>

#include <vector>

namespace osgUtil {
class CullVisitor;
}

namespace osgFbrdf {

class InheritedState;
class Surfaces;

class SceneLights : public osg::Object {
public:
    SceneLights();
    SceneLights(const SceneLights& other, const osg::CopyOp& op);
    META_Object(osgFbrdf, SceneLights)

    std::vector<fbrdf::Light> lights;  ///< of PointLights, valid ones, world
    std::vector<PlainLight> plain;
    int viewNumber = -1;  ///< GL's number of the light of the osg::View; -1: it has none
    int dropped = 0;
    bool fallbackPlaced = false;  ///< DiffuseTechnique placed GL's lights in this frame
    int lastOwnBin = 0;           ///< of effects that draw to surfaces, downwards from -1
    /// Latest used first; few, as a view seldom changes its size.
    std::vector<osg::ref_ptr<Surfaces>> surfaces;

protected:
    ~SceneLights() override;

private:
    friend SceneLights& sceneLights(osgUtil::CullVisitor& visitor);
    const osg::Node* root_ = nullptr;
    unsigned int frame_ = 0;
    bool filled_ = false;
};

/// The lights of the scene that the visitor is in; valid until its next frame.
SceneLights& sceneLights(osgUtil::CullVisitor& visitor);

/// As large as the viewport of the visitor, for its context; null where it has no viewport.
Surfaces* surfacesOf(osgUtil::CullVisitor& visitor);

/// From the coordinates of the lights to those of the eye.
osg::Matrixd worldToEye(osgUtil::CullVisitor& visitor);

/// Lights of PointLights in eye coordinates, all of them.
std::vector<fbrdf::Light> pointLightsInEye(const SceneLights& scene, const osg::Matrixd& toEye);

/// The lights of one object in eye coordinates.
struct EyeLights {
    std::vector<fbrdf::Light> lights;
    std::vector<int> lawOf;  ///< of each light; -1: falloff and cone are the runtime's
    std::vector<Law> laws;   ///< at most kMostLaws
    int culled = 0;          ///< cannot reach the object
    int dropped = 0;         ///< too many
};

/// False where a state set says that the mode GL_LIGHTn of the light is off.
bool isOn(const PlainLight& plain, const InheritedState& state);

/// Of the lights that are on; bounds: of the object, in eye coordinates.
EyeLights lightsOf(const SceneLights& scene, const osg::Matrixd& toEye, const fbrdf::Sphere& bounds,
                   const InheritedState& state);

/// The `most` that are the strongest on the object.
EyeLights strongest(const EyeLights& lights, const fbrdf::Sphere& bounds, int most);

}  // namespace osgFbrdf

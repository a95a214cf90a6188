// ViewState.h - what the effects of one view share while it is culled: the lights of the scene,
// which are found once a frame, the surfaces that passes add up in, and the numbers of bins.
//
// The lights may come after the objects in the graph, and the number of passes depends on the
// number of lights, so OSG's positional state, which is known when drawing begins, comes too late.
// The CullVisitor keeps this object; it belongs to one view and to one thread at a time, so nothing
// here needs a lock. A technique fetches the object once, when it begins to cull an effect, and
// hands it down (EffectCull.h).
#pragma once
#include "LightLists.h"

#include <fbrdf/plan/Plan.h>

#include <osg/Object>

#include <vector>

namespace osgUtil {
class CullVisitor;
}

namespace osgFbrdf {

class Surfaces;

class ViewState : public osg::Object {
public:
    ViewState();
    ViewState(const ViewState& other, const osg::CopyOp& op);
    META_Object(osgFbrdf, ViewState)

    /// The state of the visitor's view, with the lights of the scene that the visitor is in.
    /// The reference stays valid as long as the visitor; a camera within the view that has
    /// lights of its own replaces the lights while its children are culled.
    static ViewState& of(osgUtil::CullVisitor& visitor);

    const SceneLights& lights() const { return lights_; }

    /// Their lists; null where the scene or the view has none. toEye: see LightListMaker.
    const LightLists* lightLists(osgUtil::CullVisitor& visitor, const osg::Matrixd& toEye);

    /// Surfaces as large as the viewport of the visitor, for its context; null where the visitor
    /// has no viewport.
    Surfaces* surfaces(osgUtil::CullVisitor& visitor, fbrdf::ColourFormat format);

    /// -1, -2, ... within a frame: bins of effects that draw to surfaces. All effects share the
    /// surfaces, so each effect is drawn as a whole, before those that need no surface.
    int nextSurfaceBin() { return --lastSurfaceBin_; }

    /// True at the first call in a frame and scene: the diffuse technique gives PointLights the
    /// numbers of OpenGL's lights, of which all objects share one set.
    bool claimsGlLights() { return !std::exchange(glLightsClaimed_, true); }

protected:
    ~ViewState() override;

private:
    void update(osgUtil::CullVisitor& visitor);

    SceneLights lights_;
    LightListMaker listMaker_;
    const osg::Node* root_ = nullptr;  ///< below it the lights were collected; null: not yet
    unsigned int frame_ = 0;           ///< number of the frame in which they were
    int lastSurfaceBin_ = 0;
    bool glLightsClaimed_ = false;
    /// The ones used last come first. There are few, as a view seldom changes its size.
    std::vector<osg::ref_ptr<Surfaces>> surfaces_;
};

}  // namespace osgFbrdf

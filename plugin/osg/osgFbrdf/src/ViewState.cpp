#include "ViewState.h"

#include "Surfaces.h"

#include <osgUtil/CullVisitor>

#include <algorithm>
#include <cmath>

namespace osgFbrdf {
namespace {

constexpr const char* kKey = "osgFbrdf::ViewState";

// Enough for the main window and for cameras within the view that have other sizes, or effects that
// have other formats.
constexpr size_t kMostSurfaces = 4;

struct Size {
    int width, height;
};

/// Surfaces begin at the corner of the window, so they reach to the far corner of the viewport.
Size extentOf(const osg::Viewport& viewport)
{
    return {static_cast<int>(std::ceil(viewport.x() + viewport.width())),
            static_cast<int>(std::ceil(viewport.y() + viewport.height()))};
}

}  // namespace

ViewState::ViewState() = default;
ViewState::ViewState(const ViewState& other, const osg::CopyOp& op) : osg::Object(other, op) {}
ViewState::~ViewState() = default;

ViewState& ViewState::of(osgUtil::CullVisitor& visitor)
{
    osg::UserDataContainer* container = visitor.getOrCreateUserDataContainer();
    auto* state = dynamic_cast<ViewState*>(container->getUserObject(kKey));
    if (!state) {
        state = new ViewState;
        state->setName(kKey);
        container->addUserObject(state);
    }
    state->update(visitor);
    return *state;
}

void ViewState::update(osgUtil::CullVisitor& visitor)
{
    osg::Node& root = rootOfLights(visitor.getNodePath());
    const osg::FrameStamp* stamp = visitor.getFrameStamp();
    const unsigned int frame = stamp ? stamp->getFrameNumber() : 0;
    if (stamp && root_ == &root && frame_ == frame) return;
    // The numbers go on where only the root is another: the visitor comes back from the cameras
    // within a view.
    if (frame_ != frame) lastSurfaceBin_ = 0;
    glLightsClaimed_ = false;
    root_ = &root;
    frame_ = frame;
    lights_ = lightsBelow(root, visitor, std::move(lights_));
}

const LightLists* ViewState::lightLists(osgUtil::CullVisitor& visitor, const osg::Matrixd& toEye)
{
    const osg::Viewport* viewport = visitor.getViewport();
    if (!viewport || viewport->width() < 1.0 || viewport->height() < 1.0) return nullptr;
    return listMaker_.listsOf(lights_, toEye, *visitor.getProjectionMatrix(), *viewport);
}

Surfaces* ViewState::surfaces(osgUtil::CullVisitor& visitor, fbrdf::ColourFormat format)
{
    const osg::Viewport* viewport = visitor.getViewport();
    if (!viewport) return nullptr;
    const auto [width, height] = extentOf(*viewport);
    if (width < 1 || height < 1) return nullptr;
    const auto found =
        std::find_if(surfaces_.begin(), surfaces_.end(),
                     [&, width = width, height = height](const auto& surfaces) {
                         return surfaces->fit(width, height, format, visitor.getState());
                     });
    const osg::ref_ptr<Surfaces> surfaces =
        found == surfaces_.end() ? new Surfaces(width, height, format, visitor.getState())
                                 : found->get();
    if (found != surfaces_.end()) surfaces_.erase(found);
    surfaces_.insert(surfaces_.begin(), surfaces);
    if (surfaces_.size() > kMostSurfaces) surfaces_.pop_back();
    return surfaces;
}

}  // namespace osgFbrdf

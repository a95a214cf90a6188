// Surfaces.h - the RGBA32F surfaces in which passes add up before the last factor or curve is
// applied. They are as large as the viewport and have a depth buffer in common. All effects of a
// view share them and draw one after another.
//
// Passes switch framebuffer objects while the host's render stage is being drawn, and put back
// whatever was bound. So they work in a window, in a camera that draws to a texture, and in a
// framebuffer of the host's own.
#pragma once
#include <fbrdf/plan/Plan.h>

#include <osg/Camera>
#include <osg/FrameBufferObject>
#include <osg/observer_ptr>
#include <osg/State>
#include <osg/Texture2D>
#include <osgUtil/RenderBin>

#include <array>
#include <atomic>

namespace osgUtil {
class CullVisitor;
}

namespace osgFbrdf {

/// Size and attachments do not change. A context that cannot draw to the surfaces refuses them
/// while it draws.
class Surfaces : public osg::Referenced {
public:
    /// For the context of `state` alone, as framebuffers are not shared between contexts; null:
    /// none is known yet.
    Surfaces(int width, int height, osg::State* state);
    bool fit(int width, int height, const osg::State* state) const
    {
        return width == width_ && height == height_ && state == state_.get();
    }
    int width() const { return width_; }
    int height() const { return height_; }
    /// surface: any but the target.
    osg::Texture2D* texture(fbrdf::Surface surface) const { return one(surface).texture; }
    const osg::FrameBufferObject& framebuffer(fbrdf::Surface surface) const
    {
        return *one(surface).framebuffer;
    }
    /// Attaches the texture of the surface again. OSG numbers framebuffers by context, but deletes
    /// one in any context that shares objects, and the attachments are lost with it.
    void attachAnew(fbrdf::Surface surface)
    {
        const One& lost = one(surface);
        lost.framebuffer->setAttachment(osg::Camera::COLOR_BUFFER0,
                                        osg::FrameBufferAttachment(lost.texture));
    }
    /// Releases the objects of the context of `state`, or of all contexts where it is null. They
    /// are made anew when they are drawn to.
    void releaseGLObjects(osg::State* state) const;
    bool usable() const { return usable_; }
    void refuse() { usable_ = false; }

protected:
    ~Surfaces() override = default;

private:
    struct One {
        osg::ref_ptr<osg::Texture2D> texture;
        osg::ref_ptr<osg::FrameBufferObject> framebuffer;
    };
    const One& one(fbrdf::Surface surface) const;

    int width_, height_;
    osg::observer_ptr<osg::State> state_;
    osg::ref_ptr<osg::RenderBuffer> depth_;
    std::array<One, 3> surfaces_;
    std::atomic<bool> usable_{true};
};

/// Draws a bin into a surface instead of the host's target.
class SurfaceDraw : public osgUtil::RenderBin::DrawCallback {
public:
    SurfaceDraw(Surfaces& surfaces, fbrdf::Surface surface, bool clearsDepth)
        : surfaces_(&surfaces), surface_(surface), clearsDepth_(clearsDepth)
    {
    }
    void drawImplementation(osgUtil::RenderBin* bin, osg::RenderInfo& info,
                            osgUtil::RenderLeaf*& previous) override;

private:
    bool canDraw(osg::State& state) const;
    bool bind(osg::State& state) const;
    void refuse(const osgUtil::RenderBin& bin, osg::State& state) const;

    osg::ref_ptr<Surfaces> surfaces_;
    fbrdf::Surface surface_;
    bool clearsDepth_;
};

/// True where pixels of the target have several samples: surfaces have one, and would lack what the
/// others show at edges. False for a window that the host made, of which only the host knows.
bool isMultisampled(osgUtil::CullVisitor& visitor);

}  // namespace osgFbrdf

// Surfaces.h - the surfaces in which passes add up before the last factor or curve is applied. They
// are as large as the viewport and have a depth buffer in common. All effects of a view share them
// and draw one after another.
//
// Passes switch framebuffer objects while the host's render stage is being drawn, and put back
// whatever was bound. So they work in a window, in a camera that draws to a texture, and in a
// framebuffer of the host's own. Where that has several samples a pixel, passes draw to buffers
// that have as many, and the mean of the samples is what later passes read: over those that were
// drawn to, of which alpha is the share (ProgramSpec::resolved).
#pragma once
#include "ContextNeeds.h"

#include <fbrdf/plan/Plan.h>

#include <osg/Camera>
#include <osg/FrameBufferObject>
#include <osg/observer_ptr>
#include <osg/State>
#include <osg/Texture2D>
#include <osgUtil/RenderBin>

#include <OpenThreads/Mutex>

#include <array>
#include <atomic>
#include <map>
#include <vector>

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
    Surfaces(int width, int height, fbrdf::ColourFormat format, osg::State* state);
    bool fit(int width, int height, fbrdf::ColourFormat format, const osg::State* state) const
    {
        return width == width_ && height == height_ && format == format_ && state == state_.get();
    }
    int width() const { return width_; }
    int height() const { return height_; }
    /// surface: any but the target, as in what follows.
    osg::Texture2D* texture(fbrdf::Surface surface) const;
    /// What passes draw to where the target has so many samples: the texture of the surface where
    /// it has one. Called while the context draws.
    const osg::FrameBufferObject& framebuffer(fbrdf::Surface surface, int samples);
    /// Binds that framebuffer; false where it is lost. OSG gives contexts that share objects one
    /// number, and deletes names of framebuffers, which belong to one context, in any of them: the
    /// name may be nobody's by now, or another's.
    bool bind(fbrdf::Surface surface, int samples, osg::State& state);
    /// Replaces that framebuffer by one with a name of its own.
    void makeAnew(fbrdf::Surface surface, int samples);
    /// Releases the objects of the context of `state`, or of all contexts where it is null. They
    /// are made anew when they are drawn to.
    void releaseGLObjects(osg::State* state) const;
    bool usable() const { return usable_; }
    void refuse() { usable_ = false; }

protected:
    ~Surfaces() override = default;

private:
    /// For one number of samples.
    struct Buffers {
        osg::ref_ptr<osg::RenderBuffer> depth;
        std::array<osg::ref_ptr<osg::RenderBuffer>, 3> colours;  ///< null: the textures
        std::array<osg::ref_ptr<osg::FrameBufferObject>, 3> framebuffers;
    };
    /// Functions that osg::GLExtensions lacks; null before the first use.
    struct Queries {
        GLboolean(GL_APIENTRY* isFramebuffer)(GLuint) = nullptr;
        void(GL_APIENTRY* attachmentParameter)(GLenum, GLenum, GLenum, GLint*) = nullptr;
    };
    void loadQueries();
    bool isAttached(const Buffers& buffers, size_t index, osg::State& state) const;
    Buffers makeBuffers(int samples) const;
    osg::ref_ptr<osg::FrameBufferObject> makeFramebuffer(const Buffers& buffers,
                                                         size_t index) const;
    osg::FrameBufferAttachment colourOf(const Buffers& buffers, size_t index) const;

    int width_, height_;
    fbrdf::ColourFormat format_;
    osg::observer_ptr<osg::State> state_;
    Queries queries_;
    std::array<osg::ref_ptr<osg::Texture2D>, 3> textures_;
    mutable OpenThreads::Mutex mutex_;  ///< guards what follows
    std::map<int, Buffers> buffers_;    ///< by samples
    /// Without a framebuffer of their own. OSG deletes their names once they are gone, which may be
    /// those of others by then.
    std::vector<osg::ref_ptr<osg::FrameBufferObject>> lost_;
    std::atomic<bool> usable_{true};
};

/// Those that the context, which is current, can draw to.
SurfaceFormats drawableFormats(osg::State& state);

/// True where the context, which is current, can take the mean of the samples of a pixel.
bool resolvesSamples(osg::State& state);

/// Draws a bin into a surface instead of the host's target.
class SurfaceDraw : public osgUtil::RenderBin::DrawCallback {
public:
    /// clears: the surface, and its depth buffer too.
    SurfaceDraw(Surfaces& surfaces, fbrdf::Surface surface, bool clears, bool clearsDepth)
        : surfaces_(&surfaces), surface_(surface), clears_(clears), clearsDepth_(clearsDepth)
    {
    }
    void drawImplementation(osgUtil::RenderBin* bin, osg::RenderInfo& info,
                            osgUtil::RenderLeaf*& previous) override;

private:
    bool canDraw(osg::State& state, int samples) const;
    bool bind(osg::State& state, int samples) const;
    void resolve(osg::State& state, int samples) const;
    void refuse(const osgUtil::RenderBin& bin, osg::State& state) const;

    osg::ref_ptr<Surfaces> surfaces_;
    fbrdf::Surface surface_;
    bool clears_, clearsDepth_;
};

/// True where pixels of the target have several samples. False for a window that the host made, of
/// which only OpenGL knows while it draws.
bool isMultisampled(osgUtil::CullVisitor& visitor);

}  // namespace osgFbrdf

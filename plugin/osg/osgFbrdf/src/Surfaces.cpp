#include "Surfaces.h"

#include <fbrdf/base/Assert.h>

#include <osg/Camera>
#include <osg/GLExtensions>
#include <osg/GraphicsContext>
#include <osg/Notify>
#include <osgUtil/CullVisitor>

#include <algorithm>

// OpenGL 3.0 defines these, and headers of OpenGL 2 lack them.
#ifndef GL_DRAW_FRAMEBUFFER_BINDING
#define GL_DRAW_FRAMEBUFFER_BINDING 0x8CA6
#define GL_READ_FRAMEBUFFER_BINDING 0x8CAA
#endif

namespace osgFbrdf {
namespace {

osg::ref_ptr<osg::Texture2D> colourTexture(int width, int height)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(width, height);
    texture->setInternalFormat(GL_RGBA32F_ARB);
    texture->setSourceFormat(GL_RGBA);
    texture->setSourceType(GL_FLOAT);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

/// True where the framebuffer to read from is bound apart. That a function exists proves nothing,
/// as libGL has them all.
bool readsApart(const osg::GLExtensions& gl)
{
    return gl.glVersion >= 3.0f ||
           osg::isGLExtensionSupported(gl.contextID, "GL_EXT_framebuffer_blit",
                                       "GL_ARB_framebuffer_object");
}

/// Puts back at the end what the host has bound.
class BoundFramebuffers {
public:
    explicit BoundFramebuffers(const osg::GLExtensions& gl) : gl_(gl), readsApart_(readsApart(gl))
    {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
        if (readsApart_) glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
        // OSG leaves a renderbuffer bound where it makes one for a surface.
        glGetIntegerv(GL_RENDERBUFFER_BINDING_EXT, &renderbuffer_);
    }
    ~BoundFramebuffers()
    {
        // This binds both; where the one to read from is bound apart, it follows.
        gl_.glBindFramebuffer(GL_FRAMEBUFFER_EXT, static_cast<GLuint>(draw_));
        if (readsApart_ && read_ != draw_)
            gl_.glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, static_cast<GLuint>(read_));
        gl_.glBindRenderbuffer(GL_RENDERBUFFER_EXT, static_cast<GLuint>(renderbuffer_));
    }
    BoundFramebuffers(const BoundFramebuffers&) = delete;
    BoundFramebuffers& operator=(const BoundFramebuffers&) = delete;

private:
    const osg::GLExtensions& gl_;
    bool readsApart_;
    GLint draw_ = 0, read_ = 0, renderbuffer_ = 0;
};

void clearDepth(osg::State& state)
{
    state.applyMode(GL_SCISSOR_TEST, false);
    glDepthMask(GL_TRUE);
    glClearDepth(1.0);
    glClear(GL_DEPTH_BUFFER_BIT);
    state.haveAppliedAttribute(osg::StateAttribute::DEPTH);
}

}  // namespace

Surfaces::Surfaces(int width, int height, osg::State* state)
    : width_(width),
      height_(height),
      state_(state),
      depth_(new osg::RenderBuffer(width, height, GL_DEPTH_COMPONENT24))
{
    for (One& one : surfaces_) {
        one.texture = colourTexture(width, height);
        one.framebuffer = new osg::FrameBufferObject;
        one.framebuffer->setAttachment(osg::Camera::COLOR_BUFFER0,
                                       osg::FrameBufferAttachment(one.texture));
        one.framebuffer->setAttachment(osg::Camera::DEPTH_BUFFER,
                                       osg::FrameBufferAttachment(depth_));
    }
}

const Surfaces::One& Surfaces::one(fbrdf::Surface surface) const
{
    FBRDF_ASSERT(static_cast<int>(surface), !=, static_cast<int>(fbrdf::Surface::target));
    return surfaces_[static_cast<size_t>(surface) - 1];
}

void Surfaces::releaseGLObjects(osg::State* state) const
{
    depth_->releaseGLObjects(state);
    for (const One& one : surfaces_) {
        one.texture->releaseGLObjects(state);
        one.framebuffer->releaseGLObjects(state);
    }
}

bool SurfaceDraw::bind(osg::State& state) const
{
    const auto& gl = *state.get<osg::GLExtensions>();
    surfaces_->framebuffer(surface_).apply(state);
    // A texture that was made just now is bound to this unit without the state's knowledge.
    state.haveAppliedTextureAttribute(state.getActiveTextureUnit(), osg::StateAttribute::TEXTURE);
    return gl.glCheckFramebufferStatus(GL_FRAMEBUFFER_EXT) == GL_FRAMEBUFFER_COMPLETE_EXT;
}

/// Draws nothing, but counts the dynamic leaves as drawn, as the viewer waits for them.
void SurfaceDraw::refuse(const osgUtil::RenderBin& bin, osg::State& state) const
{
    surfaces_->refuse();
    for (unsigned int n = bin.computeNumberOfDynamicRenderLeaves(); n > 0; --n)
        state.decrementDynamicObjectCount();
}

bool SurfaceDraw::canDraw(osg::State& state) const
{
    if (bind(state)) return true;
    surfaces_->attachAnew(surface_);
    return bind(state);
}

void SurfaceDraw::drawImplementation(osgUtil::RenderBin* bin, osg::RenderInfo& info,
                                     osgUtil::RenderLeaf*& previous)
{
    osg::State& state = *info.getState();
    const auto& gl = *state.get<osg::GLExtensions>();
    if (!gl.isFrameBufferObjectSupported) return refuse(*bin, state);
    const BoundFramebuffers bound(gl);
    if (!canDraw(state)) return refuse(*bin, state);
    if (clearsDepth_) clearDepth(state);
    bin->drawImplementation(info, previous);
}

bool isMultisampled(osgUtil::CullVisitor& visitor)
{
    const osg::Camera* camera = visitor.getCurrentCamera();
    if (camera && !camera->getBufferAttachmentMap().empty()) {
        const auto& attachments = camera->getBufferAttachmentMap();
        return std::any_of(attachments.begin(), attachments.end(), [](const auto& attachment) {
            return attachment.second._multisampleSamples > 1;
        });
    }
    const osg::GraphicsContext* context =
        visitor.getState() ? visitor.getState()->getGraphicsContext() : nullptr;
    return context && context->getTraits() && context->getTraits()->samples > 1;
}

}  // namespace osgFbrdf

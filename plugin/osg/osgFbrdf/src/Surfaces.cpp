#include "Surfaces.h"

#include <fbrdf/base/Assert.h>

#include <osg/Camera>
#include <osg/GLExtensions>
#include <osg/GraphicsContext>
#include <osg/Notify>
#include <osgUtil/CullVisitor>

#include <OpenThreads/ScopedLock>

#include <algorithm>

// OpenGL 3.0 defines these, and headers of OpenGL 2 lack them.
#ifndef GL_DRAW_FRAMEBUFFER_BINDING
#define GL_DRAW_FRAMEBUFFER_BINDING 0x8CA6
#define GL_READ_FRAMEBUFFER_BINDING 0x8CAA
#endif

namespace osgFbrdf {
namespace {

using Lock = OpenThreads::ScopedLock<OpenThreads::Mutex>;

struct TexelFormat {
    GLint internal;
    GLenum type;
};

TexelFormat texelFormat(fbrdf::ColourFormat format)
{
    if (format == fbrdf::ColourFormat::rgba32f) return {GL_RGBA32F_ARB, GL_FLOAT};
    if (format == fbrdf::ColourFormat::rgba16f) return {GL_RGBA16F_ARB, GL_HALF_FLOAT};
    return {GL_RGBA8, GL_UNSIGNED_BYTE};
}

osg::ref_ptr<osg::Texture2D> colourTexture(int width, int height, fbrdf::ColourFormat format)
{
    const TexelFormat texels = texelFormat(format);
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(width, height);
    texture->setInternalFormat(texels.internal);
    texture->setSourceFormat(GL_RGBA);
    texture->setSourceType(texels.type);
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

/// To 0 in all channels.
void clearColour(osg::State& state)
{
    state.applyMode(GL_SCISSOR_TEST, false);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    state.haveAppliedAttribute(osg::StateAttribute::COLORMASK);
}

/// Samples of a pixel of what is bound, as far as their mean can be taken.
int samplesOfTarget(osg::State& state)
{
    GLint samples = 0;
    if (resolvesSamples(state)) glGetIntegerv(GL_SAMPLES, &samples);
    return std::max(1, samples);
}

/// libGL has the function of every extension. OSG 3.6 prefers that of
/// NV_framebuffer_multisample_coverage wherever it is, and renderbuffers then get no memory.
void forgetMissingCoverage(osg::GLExtensions& gl)
{
    if (!osg::isGLExtensionSupported(gl.contextID, "GL_NV_framebuffer_multisample_coverage"))
        gl.glRenderbufferStorageMultisampleCoverageNV = nullptr;
}

size_t indexOf(fbrdf::Surface surface)
{
    FBRDF_ASSERT(static_cast<int>(surface), !=, static_cast<int>(fbrdf::Surface::target));
    return static_cast<size_t>(surface) - 1;
}

}  // namespace

Surfaces::Surfaces(int width, int height, fbrdf::ColourFormat format, osg::State* state)
    : width_(width), height_(height), format_(format), state_(state)
{
    for (auto& texture : textures_) texture = colourTexture(width, height, format);
}

osg::Texture2D* Surfaces::texture(fbrdf::Surface surface) const
{
    return textures_[indexOf(surface)];
}

osg::FrameBufferAttachment Surfaces::colourOf(const Buffers& buffers, size_t index) const
{
    return buffers.colours[index] ? osg::FrameBufferAttachment(buffers.colours[index])
                                  : osg::FrameBufferAttachment(textures_[index]);
}

Surfaces::Buffers Surfaces::makeBuffers(int samples) const
{
    Buffers buffers;
    const auto make = [&](GLenum format) {
        return samples > 1 ? new osg::RenderBuffer(width_, height_, format, samples, samples)
                           : new osg::RenderBuffer(width_, height_, format);
    };
    buffers.depth = make(GL_DEPTH_COMPONENT24);
    for (size_t i = 0; i < textures_.size(); ++i) {
        if (samples > 1)
            buffers.colours[i] = make(static_cast<GLenum>(texelFormat(format_).internal));
        buffers.framebuffers[i] = makeFramebuffer(buffers, i);
    }
    return buffers;
}

osg::ref_ptr<osg::FrameBufferObject> Surfaces::makeFramebuffer(const Buffers& buffers,
                                                               size_t index) const
{
    osg::ref_ptr<osg::FrameBufferObject> framebuffer = new osg::FrameBufferObject;
    framebuffer->setAttachment(osg::Camera::COLOR_BUFFER0, colourOf(buffers, index));
    framebuffer->setAttachment(osg::Camera::DEPTH_BUFFER,
                               osg::FrameBufferAttachment(buffers.depth));
    return framebuffer;
}

const osg::FrameBufferObject& Surfaces::framebuffer(fbrdf::Surface surface, int samples)
{
    const Lock lock(mutex_);
    auto known = buffers_.find(samples);
    if (known == buffers_.end()) known = buffers_.emplace(samples, makeBuffers(samples)).first;
    return *known->second.framebuffers[indexOf(surface)];
}

void Surfaces::loadQueries()
{
    if (queries_.isFramebuffer) return;
    osg::setGLExtensionFuncPtr(queries_.isFramebuffer, "glIsFramebuffer", "glIsFramebufferEXT");
    osg::setGLExtensionFuncPtr(queries_.attachmentParameter,
                               "glGetFramebufferAttachmentParameteriv",
                               "glGetFramebufferAttachmentParameterivEXT");
}

/// True where the framebuffer that is bound draws to this surface.
bool Surfaces::isAttached(const Buffers& buffers, size_t index, osg::State& state) const
{
    const unsigned int context = state.getContextID();
    GLint attached = 0;
    queries_.attachmentParameter(GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT,
                                 GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_EXT, &attached);
    const osg::Texture::TextureObject* const texture = textures_[index]->getTextureObject(context);
    const GLuint expected = buffers.colours[index] ? buffers.colours[index]->getObjectID(
                                                         context, state.get<osg::GLExtensions>())
                                                   : (texture ? texture->id() : 0);
    return static_cast<GLuint>(attached) == expected;
}

bool Surfaces::bind(fbrdf::Surface surface, int samples, osg::State& state)
{
    const osg::FrameBufferObject& bound = framebuffer(surface, samples);
    const Lock lock(mutex_);
    loadQueries();
    const GLuint name = bound.getHandle(state.getContextID());
    // OpenGL 3 has an error for a name that is nobody's, and goes on drawing to what was bound.
    if (name != 0 && !queries_.isFramebuffer(name)) return false;
    bound.apply(state);
    // A texture that was made just now is bound to this unit without the state's knowledge.
    state.haveAppliedTextureAttribute(state.getActiveTextureUnit(), osg::StateAttribute::TEXTURE);
    return isAttached(buffers_.at(samples), indexOf(surface), state);
}

void Surfaces::makeAnew(fbrdf::Surface surface, int samples)
{
    const Lock lock(mutex_);
    Buffers& buffers = buffers_.at(samples);
    auto& framebuffer = buffers.framebuffers[indexOf(surface)];
    lost_.push_back(framebuffer);
    framebuffer = makeFramebuffer(buffers, indexOf(surface));
}

void Surfaces::releaseGLObjects(osg::State* state) const
{
    const Lock lock(mutex_);
    for (const auto& texture : textures_) texture->releaseGLObjects(state);
    for (const auto& [samples, buffers] : buffers_) {
        buffers.depth->releaseGLObjects(state);
        for (const auto& colour : buffers.colours)
            if (colour) colour->releaseGLObjects(state);
        for (const auto& framebuffer : buffers.framebuffers) framebuffer->releaseGLObjects(state);
    }
}

bool resolvesSamples(osg::State& state)
{
    const auto& gl = *state.get<osg::GLExtensions>();
    const auto has = [&](const char* extension) {
        return osg::isGLExtensionSupported(state.getContextID(), extension);
    };
    return gl.glVersion >= 3.0f || has("GL_ARB_framebuffer_object") ||
           (has("GL_EXT_framebuffer_blit") && has("GL_EXT_framebuffer_multisample"));
}

SurfaceFormats drawableFormats(osg::State& state)
{
    const auto& gl = *state.get<osg::GLExtensions>();
    if (!gl.isFrameBufferObjectSupported) return {};
    const bool floats = gl.glVersion >= 3.0f ||
                        osg::isGLExtensionSupported(state.getContextID(), "GL_ARB_texture_float");
    const BoundFramebuffers bound(gl);
    state.unbindPixelBufferObject();
    // OSG applies textures before it asks, so theirs is needed.
    GLint bound2d = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound2d);
    const auto isDrawable = [&](fbrdf::ColourFormat format) {
        const TexelFormat texels = texelFormat(format);
        GLuint texture = 0, framebuffer = 0;
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, texels.internal, 4, 4, 0, GL_RGBA, texels.type, nullptr);
        gl.glGenFramebuffers(1, &framebuffer);
        gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, framebuffer);
        gl.glFramebufferTexture2D(GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_TEXTURE_2D,
                                  texture, 0);
        const bool complete =
            gl.glCheckFramebufferStatus(GL_FRAMEBUFFER_EXT) == GL_FRAMEBUFFER_COMPLETE_EXT;
        gl.glDeleteFramebuffers(1, &framebuffer);
        glDeleteTextures(1, &texture);
        return complete;
    };
    const SurfaceFormats formats{floats && isDrawable(fbrdf::ColourFormat::rgba32f),
                                 floats && isDrawable(fbrdf::ColourFormat::rgba16f),
                                 isDrawable(fbrdf::ColourFormat::rgba8)};
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound2d));
    return formats;
}

bool SurfaceDraw::bind(osg::State& state, int samples) const
{
    return surfaces_->bind(surface_, samples, state) &&
           state.get<osg::GLExtensions>()->glCheckFramebufferStatus(GL_FRAMEBUFFER_EXT) ==
               GL_FRAMEBUFFER_COMPLETE_EXT;
}

/// Draws nothing, but counts the dynamic leaves as drawn, as the viewer waits for them.
void SurfaceDraw::refuse(const osgUtil::RenderBin& bin, osg::State& state) const
{
    surfaces_->refuse();
    for (unsigned int n = bin.computeNumberOfDynamicRenderLeaves(); n > 0; --n)
        state.decrementDynamicObjectCount();
}

bool SurfaceDraw::canDraw(osg::State& state, int samples) const
{
    if (bind(state, samples)) return true;
    surfaces_->makeAnew(surface_, samples);
    return bind(state, samples);
}

/// The mean of the samples becomes the texel of the surface.
void SurfaceDraw::resolve(osg::State& state, int samples) const
{
    const int width = surfaces_->width(), height = surfaces_->height();
    state.applyMode(GL_SCISSOR_TEST, false);
    // A framebuffer that is applied for the first time is bound to both.
    bind(state, 1);
    surfaces_->framebuffer(surface_, samples)
        .apply(state, osg::FrameBufferObject::READ_FRAMEBUFFER);
    state.get<osg::GLExtensions>()->glBlitFramebuffer(0, 0, width, height, 0, 0, width, height,
                                                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void SurfaceDraw::drawImplementation(osgUtil::RenderBin* bin, osg::RenderInfo& info,
                                     osgUtil::RenderLeaf*& previous)
{
    osg::State& state = *info.getState();
    auto& gl = *state.get<osg::GLExtensions>();
    if (!gl.isFrameBufferObjectSupported) return refuse(*bin, state);
    const BoundFramebuffers bound(gl);
    const int samples = samplesOfTarget(state);
    if (samples > 1) forgetMissingCoverage(gl);
    if (!canDraw(state, samples)) return refuse(*bin, state);
    if (clears_ && samples > 1) clearColour(state);
    if (clearsDepth_) clearDepth(state);
    bin->drawImplementation(info, previous);
    if (samples > 1) resolve(state, samples);
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

#include "Surfaces.h"

#include "UploadGuard.h"

#include <fbrdf/base/Assert.h>

namespace fbrdf::gl {
namespace {

/// OpenGL ES 2.0 has neither levels of textures nor sized formats, and promises 16 bits of depth.
bool isOld(const Functions& gl)
{
    return gl.es != 0 && gl.es < 30;
}

}  // namespace

Surfaces::Surfaces(DevicePtr device, const SurfaceFormat& format)
    : device_(std::move(device)), format_(format)
{
    FBRDF_ASSERT(format.width, >, 0);
    FBRDF_ASSERT(format.height, >, 0);
    const UploadGuard guard(*device_);
    // More would be an error of GL, which the host would find.
    if (isMultisampled() && format_.samples > integer(device_->gl, GL_MAX_SAMPLES)) {
        refuse();
        return;
    }
    // One depth buffer for all: passes into different surfaces must agree on what is visible.
    createDepth();
    usable_ =
        create(accumulation_, "accumulation") && create(scratch_, "scratch") && create(sum_, "sum");
    if (usable_) return;
    // What was made before the failure would only take memory.
    for (One* one : {&accumulation_, &scratch_, &sum_}) *one = One();
    depth_.reset();
    refuse();
}

void Surfaces::refuse() const
{
    const std::string samples =
        isMultisampled() ? " with " + std::to_string(format_.samples) + " samples" : "";
    device_->log(Severity::warning, std::string("no ") + colourFormatName(format_.colour) +
                                        " surface of " + std::to_string(format_.width) + "x" +
                                        std::to_string(format_.height) + samples +
                                        " can be drawn to");
}

void Surfaces::createDepth()
{
    const Functions& gl = device_->gl;
    depth_ = createObject(device_, ObjectKind::renderbuffer);
    gl.BindRenderbuffer(GL_RENDERBUFFER, depth_.name());
    const GLenum fixed = isOld(gl) ? GL_DEPTH_COMPONENT16 : GL_DEPTH_COMPONENT24;
    // Float depth where the target has it: what was told apart there must be told apart here.
    storage(format_.floatDepth ? GLenum(GL_DEPTH_COMPONENT32F) : fixed);
    label(*device_, ObjectKind::renderbuffer, depth_, "depth");
}

/// Of the renderbuffer that is bound.
void Surfaces::storage(GLenum internal) const
{
    const Functions& gl = device_->gl;
    if (isMultisampled())
        gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, format_.samples, internal, format_.width,
                                          format_.height);
    else
        gl.RenderbufferStorage(GL_RENDERBUFFER, internal, format_.width, format_.height);
}

void Surfaces::allocate() const
{
    const Functions& gl = device_->gl;
    const auto allocated = [&](GLint internal, GLenum type) {
        gl.TexImage2D(GL_TEXTURE_2D, 0, internal, format_.width, format_.height, 0, GL_RGBA, type,
                      nullptr);
    };
    if (format_.colour == ColourFormat::rgba32f) return allocated(GL_RGBA32F, GL_FLOAT);
    if (format_.colour == ColourFormat::rgba16f) return allocated(GL_RGBA16F, GL_HALF_FLOAT);
    if (format_.colour == ColourFormat::rgba16) return allocated(GL_RGBA16, GL_UNSIGNED_SHORT);
    allocated(isOld(gl) ? GL_RGBA : GL_RGBA8, GL_UNSIGNED_BYTE);
}

bool Surfaces::create(One& one, const std::string& name)
{
    const Functions& gl = device_->gl;
    one.texture = createObject(device_, ObjectKind::texture);
    gl.BindTexture(GL_TEXTURE_2D, one.texture.name());
    // Each fragment reads the texel at its own place, so nothing is to be filtered.
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    if (!isOld(gl)) gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    allocate();
    label(*device_, ObjectKind::texture, one.texture, name);
    one.framebuffer = createObject(device_, ObjectKind::framebuffer);
    gl.BindFramebuffer(gl.drawFramebuffer(), one.framebuffer.name());
    gl.FramebufferTexture2D(gl.drawFramebuffer(), GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                            one.texture.name(), 0);
    if (!isMultisampled())
        gl.FramebufferRenderbuffer(gl.drawFramebuffer(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                   depth_.name());
    label(*device_, ObjectKind::framebuffer, one.framebuffer, name);
    // Whether a format can be drawn to is the driver's choice in OpenGL 2.1 and ES.
    if (gl.CheckFramebufferStatus(gl.drawFramebuffer()) != GL_FRAMEBUFFER_COMPLETE) return false;
    return !isMultisampled() || createSamples(one, name + " samples");
}

bool Surfaces::createSamples(One& one, const std::string& name)
{
    const Functions& gl = device_->gl;
    one.buffer = createObject(device_, ObjectKind::renderbuffer);
    gl.BindRenderbuffer(GL_RENDERBUFFER, one.buffer.name());
    // Sums of several samples are floats (PlanRequest::resolves).
    storage(format_.colour == ColourFormat::rgba16f ? GL_RGBA16F : GL_RGBA32F);
    label(*device_, ObjectKind::renderbuffer, one.buffer, name);
    one.drawn = createObject(device_, ObjectKind::framebuffer);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, one.drawn.name());
    gl.FramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                               one.buffer.name());
    gl.FramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                               depth_.name());
    label(*device_, ObjectKind::framebuffer, one.drawn, name);
    return gl.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void Surfaces::resolve(Surface surface) const
{
    const Functions& gl = device_->gl;
    const One& one = of(surface);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, one.drawn.name());
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, one.framebuffer.name());
    gl.BlitFramebuffer(0, 0, format_.width, format_.height, 0, 0, format_.width, format_.height,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

const Surfaces::One& Surfaces::of(Surface surface) const
{
    FBRDF_ASSERT(surface != Surface::target, ==, true);
    if (surface == Surface::sum) return sum_;
    return surface == Surface::scratch ? scratch_ : accumulation_;
}

}  // namespace fbrdf::gl

#include "Surfaces.h"

#include "UploadGuard.h"

#include <fbrdf/brdf/Error.h>

namespace fbrdf::gl {

bool Surfaces::prepare(int width, int height)
{
    if (width == width_ && height == height_) return usable_;
    width_ = width;
    height_ = height;
    const UploadGuard guard(*device_);
    const Functions& gl = device_->gl;
    depth_ = createObject(device_, ObjectKind::renderbuffer);
    gl.BindRenderbuffer(GL_RENDERBUFFER, depth_.name());
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    label(*device_, ObjectKind::renderbuffer, depth_, "depth");
    usable_ =
        create(accumulation_, "accumulation") && create(scratch_, "scratch") && create(sum_, "sum");
    if (!usable_)
        device_->log(Severity::warning, "no RGBA32F surface of " + std::to_string(width) + "x" +
                                            std::to_string(height) + " can be drawn to");
    return usable_;
}

bool Surfaces::create(One& one, const std::string& name)
{
    const Functions& gl = device_->gl;
    one.texture = createObject(device_, ObjectKind::texture);
    gl.BindTexture(GL_TEXTURE_2D, one.texture.name());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width_, height_, 0, GL_RGBA, GL_FLOAT, nullptr);
    label(*device_, ObjectKind::texture, one.texture, name);
    one.framebuffer = createObject(device_, ObjectKind::framebuffer);
    gl.BindFramebuffer(gl.drawFramebuffer(), one.framebuffer.name());
    gl.FramebufferTexture2D(gl.drawFramebuffer(), GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                            one.texture.name(), 0);
    gl.FramebufferRenderbuffer(gl.drawFramebuffer(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                               depth_.name());
    label(*device_, ObjectKind::framebuffer, one.framebuffer, name);
    return gl.CheckFramebufferStatus(gl.drawFramebuffer()) == GL_FRAMEBUFFER_COMPLETE;
}

GLuint Surfaces::framebuffer(Surface surface) const
{
    return of(surface).framebuffer.name();
}

GLuint Surfaces::texture(Surface surface) const
{
    return of(surface).texture.name();
}

}  // namespace fbrdf::gl

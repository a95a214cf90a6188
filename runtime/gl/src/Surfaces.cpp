#include "Surfaces.h"

#include "UploadGuard.h"

#include <fbrdf/base/Error.h>

namespace fbrdf::gl {

bool Surfaces::prepare(const Format& format)
{
    if (format == format_) return usable_;
    format_ = format;
    const UploadGuard guard(*device_);
    createDepth();
    usable_ =
        create(accumulation_, "accumulation") && create(scratch_, "scratch") && create(sum_, "sum");
    if (!usable_)
        device_->log(Severity::warning, std::string("no ") + colourFormatName(format.colour) +
                                            " surface of " + std::to_string(format.width) + "x" +
                                            std::to_string(format.height) + " can be drawn to");
    return usable_;
}

void Surfaces::createDepth()
{
    const Functions& gl = device_->gl;
    depth_ = createObject(device_, ObjectKind::renderbuffer);
    gl.BindRenderbuffer(GL_RENDERBUFFER, depth_.name());
    // OpenGL ES 2.0 promises 16 bits only.
    const bool old = gl.es != 0 && gl.es < 30;
    const GLenum fixed = old ? GL_DEPTH_COMPONENT16 : GL_DEPTH_COMPONENT24;
    gl.RenderbufferStorage(GL_RENDERBUFFER, format_.floatDepth ? GL_DEPTH_COMPONENT32F : fixed,
                           format_.width, format_.height);
    label(*device_, ObjectKind::renderbuffer, depth_, "depth");
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
    const bool old = gl.es != 0 && gl.es < 30;  // neither levels nor sized formats
    if (!old) gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    if (format_.colour == ColourFormat::rgba32f)
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, format_.width, format_.height, 0, GL_RGBA,
                      GL_FLOAT, nullptr);
    else if (format_.colour == ColourFormat::rgba16f)
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, format_.width, format_.height, 0, GL_RGBA,
                      GL_HALF_FLOAT, nullptr);
    else
        gl.TexImage2D(GL_TEXTURE_2D, 0, old ? GL_RGBA : GL_RGBA8, format_.width, format_.height, 0,
                      GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
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

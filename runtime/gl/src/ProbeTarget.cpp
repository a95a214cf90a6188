#include "ProbeTarget.h"

#include "Program.h"
#include "TextureUpload.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/shaders/ShaderSource.h>

namespace fbrdf::gl {

ProbeTarget::ProbeTarget(const DevicePtr& device, StateGuard& state, int side, GLint internal,
                         GLenum type, const std::string& what)
    : device_(device), what_(what)
{
    const Functions& gl = device->gl;
    colour_ = createObject(device, ObjectKind::texture);
    state.bindTexture(0, GL_TEXTURE_2D, colour_.name());
    setSampling(gl, GL_TEXTURE_2D, false);
    const bool old = gl.es != 0 && gl.es < 30;
    gl.TexImage2D(GL_TEXTURE_2D, 0, old ? GL_RGBA : internal, side, side, 0, GL_RGBA, type,
                  nullptr);
    framebuffer_ = createObject(device, ObjectKind::framebuffer);
    // For drawing and for reading.
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(), 0);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ErrorKind::gl, what,
                    Found("a target that cannot be drawn to").expected("one that can"));
    Target target;
    target.framebuffer = framebuffer_.name();
    target.width = target.height = side;
    state.setTarget(target);
    gl.version >= 30 ? gl.Disablei(GL_BLEND, 0) : gl.Disable(GL_BLEND);
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_ALWAYS);
}

void ProbeTarget::use(const std::string& fragment)
{
    const Object vertex = compiledShader(device_, GL_VERTEX_SHADER,
                                         filterProbeVertexSource(device_->capabilities.glsl)),
                 shader = compiledShader(device_, GL_FRAGMENT_SHADER, fragment);
    program_ = linkedShaders(device_, vertex, shader, what_ + " probe");
    device_->gl.UseProgram(program_.name());
}

GLint ProbeTarget::uniform(const char* name) const
{
    return device_->gl.GetUniformLocation(program_.name(), name);
}

}  // namespace fbrdf::gl

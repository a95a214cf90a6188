#include "TargetInfo.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

namespace fbrdf::gl {
namespace {

[[noreturn]] void fail(GLuint framebuffer, const std::string& what)
{
    throw Error(ErrorKind::gl, "framebuffer " + std::to_string(framebuffer), what);
}

ColourFormat formatOf(bool isFloat, GLint redBits)
{
    if (isFloat) {
        if (redBits == 32) return ColourFormat::rgba32f;
        return redBits == 16 ? ColourFormat::rgba16f : ColourFormat::other;
    }
    if (redBits == 8) return ColourFormat::rgba8;
    return redBits == 16 ? ColourFormat::rgba16 : ColourFormat::other;
}

GLint parameter(const Functions& gl, GLenum attachment, GLenum name)
{
    GLint value = 0;
    gl.GetFramebufferAttachmentParameteriv(gl.drawFramebuffer(), attachment, name, &value);
    return value;
}

/// The attachment by which the first draw buffer of a window is queried.
// The query takes the name of one buffer; GL_FRONT and GL_BACK name two where there is stereo.
GLenum queriedName(const Functions& gl, GLenum drawBuffer)
{
    if (gl.es) return drawBuffer;
    switch (drawBuffer) {
        case GL_FRONT: return GL_FRONT_LEFT;
        case GL_BACK:
        case GL_FRONT_AND_BACK: return GL_BACK_LEFT;
        default: return drawBuffer;
    }
}

/// The depth buffer of a window has a name of its own.
GLenum depthAttachment(GLuint framebuffer)
{
    return framebuffer == 0 ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
}

bool isFloat(const Functions& gl, GLenum attachment)
{
    return parameter(gl, attachment, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
}

ColourFormat queriedFormat(const Functions& gl, GLuint framebuffer)
{
    const auto buffer = queriedName(gl, static_cast<GLenum>(integer(gl, GL_DRAW_BUFFER0)));
    if (buffer == GL_NONE) fail(framebuffer, Found("no draw buffer").expected("a colour buffer"));
    if (parameter(gl, buffer, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE)
        fail(framebuffer, Found("nothing attached to its draw buffer").expected("a colour buffer"));
    if (parameter(gl, depthAttachment(framebuffer), GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) ==
        GL_NONE)
        fail(framebuffer, Found("no depth buffer").expected("one"));
    return formatOf(isFloat(gl, buffer), parameter(gl, buffer, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE));
}

ColourFormat formatBefore30(const Functions& gl, GLuint framebuffer)
{
    if (integer(gl, GL_DEPTH_BITS) == 0)
        fail(framebuffer, Found("no depth buffer").expected("one"));
    // Attachments cannot be queried before 3.0. Bits are those of the framebuffer that is bound.
    const bool isFloat = gl.ARB_color_buffer_float && integer(gl, GL_RGBA_FLOAT_MODE_ARB) != 0;
    return formatOf(isFloat, integer(gl, GL_RED_BITS));
}

}  // namespace

TargetInfo targetInfo(const Device& device, const Target& target)
{
    const Functions& gl = device.gl;
    const GLuint framebuffer = target.framebuffer;
    if (device.capabilities.framebufferObjects) {
        // The guard has bound the target already, so queries without a name are about it.
        const GLenum status = gl.CheckFramebufferStatus(gl.drawFramebuffer());
        if (status != GL_FRAMEBUFFER_COMPLETE)
            fail(framebuffer,
                 Found("status " + std::to_string(status)).expected("a complete framebuffer"));
    }
    TargetInfo info;
    info.format = gl.has(30, 30) ? queriedFormat(gl, framebuffer) : formatBefore30(gl, framebuffer);
    info.floatDepth = gl.has(30, 30) && isFloat(gl, depthAttachment(framebuffer));
    info.transfer = target.transfer;
    // Multisampled edges would read texels of a surface that nothing was drawn to.
    info.multisampled = integer(gl, GL_SAMPLES) > 1;
    return info;
}

}  // namespace fbrdf::gl

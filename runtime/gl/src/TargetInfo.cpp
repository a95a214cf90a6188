#include "TargetInfo.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace fbrdf::gl {
namespace {

[[noreturn]] void fail(GLuint framebuffer, const std::string& what)
{
    throw Error(ErrorKind::gl, "framebuffer " + std::to_string(framebuffer), what);
}

/// What is stored of a colour, by its coarsest channel.
struct Channels {
    GLenum type;  ///< GL_FLOAT, GL_UNSIGNED_NORMALIZED or GL_SIGNED_NORMALIZED
    GLint bits;
};

/// Of the floats that can be drawn to: 32 and 16 bits have a sign, 11 and 10 have none (OpenGL 4.6,
/// 2.3.4).
int mantissaBits(GLint bits)
{
    switch (bits) {
        case 32: return 23;
        case 16: return 10;
        case 11: return 6;
        default: return 5;
    }
}

StoreUnit unitOf(const Channels& c)
{
    // 2^-14 is the smallest normal number of all floats of fewer than 32 bits.
    if (c.type == GL_FLOAT) return {std::exp2(-mantissaBits(c.bits)), c.bits < 32 ? 0x1p-14 : 0.0};
    const GLint bits = c.type == GL_SIGNED_NORMALIZED ? c.bits - 1 : c.bits;
    return {0.0, 1.0 / (std::exp2(bits) - 1.0)};
}

ColourFormat formatOf(const Channels& c)
{
    if (c.type == GL_FLOAT) {
        if (c.bits == 32) return ColourFormat::rgba32f;
        return c.bits == 16 ? ColourFormat::rgba16f : ColourFormat::other;
    }
    if (c.type == GL_SIGNED_NORMALIZED) return ColourFormat::other;
    if (c.bits == 8) return ColourFormat::rgba8;
    return c.bits == 16 ? ColourFormat::rgba16 : ColourFormat::other;
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

/// The fewest bits of the three channels; those that are not stored do not count.
template <class BitsOf>
GLint fewestBits(std::initializer_list<GLenum> channels, const BitsOf& bitsOf)
{
    GLint fewest = 0;
    for (const GLenum channel : channels) {
        const GLint bits = bitsOf(channel);
        if (bits > 0 && (fewest == 0 || bits < fewest)) fewest = bits;
    }
    return fewest;
}

Channels queriedChannels(const Functions& gl, GLuint framebuffer)
{
    const auto buffer = queriedName(gl, static_cast<GLenum>(integer(gl, GL_DRAW_BUFFER0)));
    if (buffer == GL_NONE) fail(framebuffer, Found("no draw buffer").expected("a colour buffer"));
    if (parameter(gl, buffer, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE)
        fail(framebuffer, Found("nothing attached to its draw buffer").expected("a colour buffer"));
    if (parameter(gl, depthAttachment(framebuffer), GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) ==
        GL_NONE)
        fail(framebuffer, Found("no depth buffer").expected("one"));
    const auto type =
        static_cast<GLenum>(parameter(gl, buffer, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE));
    if (type == GL_INT || type == GL_UNSIGNED_INT)
        fail(framebuffer,
             Found("a colour buffer of integers").expected("one of floats or of fixed point"));
    return {type,
            fewestBits({GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE,
                        GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE},
                       [&](GLenum name) { return parameter(gl, buffer, name); })};
}

Channels channelsBefore30(const Functions& gl, GLuint framebuffer)
{
    if (integer(gl, GL_DEPTH_BITS) == 0)
        fail(framebuffer, Found("no depth buffer").expected("one"));
    // Attachments cannot be queried before 3.0. Bits are those of the framebuffer that is bound.
    const bool isFloat = gl.ARB_color_buffer_float && integer(gl, GL_RGBA_FLOAT_MODE_ARB) != 0;
    return {isFloat ? GLenum(GL_FLOAT) : GLenum(GL_UNSIGNED_NORMALIZED),
            fewestBits({GL_RED_BITS, GL_GREEN_BITS, GL_BLUE_BITS},
                       [&](GLenum name) { return integer(gl, name); })};
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
    const Channels channels =
        gl.has(30, 30) ? queriedChannels(gl, framebuffer) : channelsBefore30(gl, framebuffer);
    info.format = formatOf(channels);
    if (info.format == ColourFormat::other) info.otherUnit = unitOf(channels);
    info.floatDepth = gl.has(30, 30) && isFloat(gl, depthAttachment(framebuffer));
    info.transfer = target.transfer;
    info.samples = std::max(1, integer(gl, GL_SAMPLES));
    return info;
}

}  // namespace fbrdf::gl

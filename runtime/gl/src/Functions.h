// Functions.h - the GL function table of one context. The only header that brings in GL names.
#pragma once
#include <glad/gl.h>

#include <fbrdf/gl/Renderer.h>

namespace fbrdf::gl {

/// glad's table under a name of our own: the host may have another GladGLContext.
struct Functions : GladGLContext {
    int version = 0;  ///< 10 x major + minor; 21 in OpenGL ES, the desktop version next to it
    int es = 0;       ///< 10 x major + minor of OpenGL ES; 0 on a desktop
    bool hasClipControl = false;

    bool hasExtension(const char* name) const;
    bool has(int desktop, int embedded) const { return es ? es >= embedded : version >= desktop; }
    bool hasArrays() const { return has(30, 30); }
    bool hasSamplers() const { return has(33, 30); }
    bool hasVolumes() const { return has(21, 30); }
    bool hasUnpackBuffer() const { return has(21, 30); }
    /// ES 2.0 has one binding for drawing and reading.
    GLenum drawFramebuffer() const
    {
        return es != 0 && es < 30 ? GL_FRAMEBUFFER : GL_DRAW_FRAMEBUFFER;
    }
    void clearDepth(double depth) const
    {
        es ? ClearDepthf(static_cast<GLfloat>(depth)) : ClearDepth(depth);
    }
    void depthRange(double near, double far) const
    {
        es ? DepthRangef(static_cast<GLfloat>(near), static_cast<GLfloat>(far))
           : DepthRange(near, far);
    }
};

/// Throws Error(gl) where the loader, the context or a function that the version promises is
/// missing.
Functions loadFunctions(LoadFunction load, void* user);

/// The name of an object or an enumerator as glGetIntegerv returns it.
inline GLuint unsignedOf(GLint value)
{
    return static_cast<GLuint>(value);
}

}  // namespace fbrdf::gl

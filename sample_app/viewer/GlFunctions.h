// GlFunctions.h - the GL function table of the current context, for the few calls that the viewer
// makes itself, and a texture of floats.
#pragma once
#include <fbrdf/gl/Renderer.h>
#include <glad/gl.h>

namespace fbrdf::viewer {

/// Throws Error(gl) where `load` finds no context.
GladGLContext loadGlFunctions(gl::LoadFunction load);

/// Gives an RGBA32F texture, which has one level and is filtered linearly within its edges, another
/// picture of that size: rows as GL counts them, or null for any.
void setFloatTexture(const GladGLContext& gl, GLuint texture, int width, int height,
                     const float* rgba, GLint format = GL_RGBA32F);

}  // namespace fbrdf::viewer

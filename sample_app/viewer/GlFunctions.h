// GlFunctions.h - the GL function table of the current context, for the few calls that the viewer
// makes itself.
#pragma once
#include <fbrdf/gl/Renderer.h>
#include <glad/gl.h>

namespace fbrdf::viewer {

/// Throws Error(gl) where `load` finds no context.
GladGLContext loadGlFunctions(gl::LoadFunction load);

}  // namespace fbrdf::viewer

// Functions.h - the GL function table of one context. The only header that brings in GL names.
#pragma once
#include <glad/gl.h>

#include <fbrdf/gl/Renderer.h>

namespace fbrdf::gl {

/// glad's table under a name of our own: the host may have another GladGLContext.
struct Functions : GladGLContext {
    int version = 0;  ///< 10 x major + minor
};

/// Throws Error(gl) where the loader, the context or a function that the version promises is
/// missing.
Functions loadFunctions(LoadFunction load, void* user);

}  // namespace fbrdf::gl

// Gl.h - GL functions for tests: glad's table of one context.
#pragma once
#include <glad/gl.h>

#include <fbrdf/headless/Context.h>

namespace fbrdf::test {

/// Table of the context that is current. Throws std::runtime_error where there is none.
GladGLContext loadGl(HeadlessContext::Load load);

/// Compiles and links; throws std::runtime_error with the log. Attributes as in every program of
/// the runtime (ShaderSource.h), at locations 0, 1, 2.
GLuint linkProgram(const GladGLContext& gl, const std::string& vertex, const std::string& fragment);

}  // namespace fbrdf::test

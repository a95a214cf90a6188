// Program.h - links programs of two stages, for pictures that are not drawn by the renderer.
#pragma once
#include <glad/gl.h>

#include <string>

namespace fbrdf::truth {

/// Compiles and links; throws std::runtime_error with the log. Attributes as in every program of
/// the runtime (ShaderSource.h), at locations 0, 1, 2.
GLuint linkProgram(const GladGLContext& gl, const std::string& vertex, const std::string& fragment);

}  // namespace fbrdf::truth

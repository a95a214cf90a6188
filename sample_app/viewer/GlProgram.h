// GlProgram.h - programs of the viewer's own shaders (shaders/), for what the runtime does not
// draw.
#pragma once
#include "GlFunctions.h"

namespace fbrdf::viewer {

/// Links two files of shaders/, by their names. Throws Error(gl) with the compiler's words.
GLuint linkedProgram(const GladGLContext& gl, const char* vertex, const char* fragment);

/// Draws a strip of so many vertices, which the current program makes of their numbers, with a 2D
/// texture in unit 0. Leaves no program.
void drawCorners(const GladGLContext& gl, GLuint vertexArray, GLuint texture, int corners);

/// Text of shaders/<name>; empty where there is no such file.
std::string viewerShader(const char* name);

}  // namespace fbrdf::viewer

#include "GlProgram.h"

#include <fbrdf/base/Error.h>

#include <string_view>

namespace fbrdf {

std::string_view embeddedViewerShader(std::string_view name);  // made by EmbedShaders.cmake

}  // namespace fbrdf

namespace fbrdf::viewer {
namespace {

GLuint compiled(const GladGLContext& gl, GLenum stage, const char* name)
{
    const std::string source = viewerShader(name);
    const char* const text = source.c_str();
    const GLuint shader = gl.CreateShader(stage);
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    GLint isCompiled = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &isCompiled);
    if (!isCompiled) {
        char log[1024] = "";
        gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
        throw Error(ErrorKind::gl, name, std::string("a shader that GL refuses: ") + log);
    }
    return shader;
}

}  // namespace

GLuint linkedProgram(const GladGLContext& gl, const char* vertex, const char* fragment)
{
    const GLuint program = gl.CreateProgram();
    for (const GLuint shader :
         {compiled(gl, GL_VERTEX_SHADER, vertex), compiled(gl, GL_FRAGMENT_SHADER, fragment)}) {
        gl.AttachShader(program, shader);
        gl.DeleteShader(shader);  // goes with the program
    }
    gl.LinkProgram(program);
    GLint isLinked = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &isLinked);
    if (!isLinked) throw Error(ErrorKind::gl, fragment, "a program that does not link");
    return program;
}

void drawCorners(const GladGLContext& gl, GLuint vertexArray, GLuint texture, int corners)
{
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.BindVertexArray(vertexArray);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, corners);
    gl.BindVertexArray(0);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    gl.UseProgram(0);
}

std::string viewerShader(const char* name)
{
    return std::string(embeddedViewerShader(name));
}

}  // namespace fbrdf::viewer

#include <fbrdf/truth/Program.h>

#include <stdexcept>

namespace fbrdf::truth {
namespace {

GLuint compile(const GladGLContext& gl, GLenum stage, const std::string& source)
{
    const GLuint shader = gl.CreateShader(stage);
    const GLchar* text = source.c_str();
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    GLint ok = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok) return shader;
    char log[4096] = {};
    gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
    throw std::runtime_error(std::string("shader: ") + log);
}

}  // namespace

GLuint linkProgram(const GladGLContext& gl, const std::string& vertex, const std::string& fragment)
{
    const GLuint program = gl.CreateProgram();
    const GLuint stages[] = {compile(gl, GL_VERTEX_SHADER, vertex),
                             compile(gl, GL_FRAGMENT_SHADER, fragment)};
    for (const GLuint shader : stages) {
        gl.AttachShader(program, shader);
        gl.DeleteShader(shader);
    }
    const char* const attributes[] = {"fbrdfVertex", "fbrdfVertexNormal", "fbrdfVertexTangent"};
    for (GLuint i = 0; i < 3; ++i) gl.BindAttribLocation(program, i, attributes[i]);
    gl.LinkProgram(program);
    GLint ok = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &ok);
    if (ok) return program;
    char log[4096] = {};
    gl.GetProgramInfoLog(program, sizeof log, nullptr, log);
    throw std::runtime_error(std::string("program: ") + log);
}

}  // namespace fbrdf::truth

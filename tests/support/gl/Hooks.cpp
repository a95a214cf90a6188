#include "Hooks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace fbrdf::test {
namespace {

Hooks* active = nullptr;  // hooked functions have no user pointer of their own

void count(const char* kind, int change)
{
    active->alive[kind] += change;
    (change > 0 ? active->made : active->deleted) += std::abs(change);
}

#define FBRDF_HOOK_OBJECTS(Kind)                                                            \
    void GLAD_API_PTR gen##Kind(GLsizei n, GLuint* names)                                   \
    {                                                                                       \
        if (active->loseContext) return static_cast<void>(std::fill(names, names + n, 0u)); \
        active->real.Gen##Kind(n, names);                                                   \
        count(#Kind, n);                                                                    \
    }                                                                                       \
    void GLAD_API_PTR delete##Kind(GLsizei n, const GLuint* names)                          \
    {                                                                                       \
        active->real.Delete##Kind(n, names);                                                \
        count(#Kind, -n);                                                                   \
    }
FBRDF_HOOK_OBJECTS(Textures)
FBRDF_HOOK_OBJECTS(Buffers)
FBRDF_HOOK_OBJECTS(VertexArrays)
FBRDF_HOOK_OBJECTS(Framebuffers)
FBRDF_HOOK_OBJECTS(Renderbuffers)
#undef FBRDF_HOOK_OBJECTS

GLuint GLAD_API_PTR createShader(GLenum stage)
{
    if (active->loseContext) return 0;
    count("Shader", 1);
    return active->real.CreateShader(stage);
}

void GLAD_API_PTR deleteShader(GLuint shader)
{
    count("Shader", -1);
    active->real.DeleteShader(shader);
}

GLuint GLAD_API_PTR createProgram()
{
    if (active->loseContext) return 0;
    count("Program", 1);
    return active->real.CreateProgram();
}

void GLAD_API_PTR deleteProgram(GLuint program)
{
    count("Program", -1);
    active->real.DeleteProgram(program);
}

void GLAD_API_PTR shaderSource(GLuint shader, GLsizei n, const GLchar* const* text,
                               const GLint* length)
{
    const GLchar* const broken = "#version 120\nthis is no shader\n";
    if (active->corruptShaders)
        active->real.ShaderSource(shader, 1, &broken, nullptr);
    else
        active->real.ShaderSource(shader, n, text, length);
}

/// The program gets a second main() where a test asks for it.
void GLAD_API_PTR linkProgram(GLuint program)
{
    if (active->spoilPrograms) {
        const GLchar* const second = "void main() { gl_Position = vec4(1.0); }\n";
        const GLuint shader = active->real.CreateShader(GL_VERTEX_SHADER);
        active->real.ShaderSource(shader, 1, &second, nullptr);
        active->real.CompileShader(shader);
        active->real.AttachShader(program, shader);
        active->real.DeleteShader(shader);
    }
    active->real.LinkProgram(program);
}

GLenum GLAD_API_PTR checkFramebufferStatus(GLenum target)
{
    GLint type = GL_NONE;
    active->real.GetFramebufferAttachmentParameteriv(target, GL_COLOR_ATTACHMENT0,
                                                     GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type == GL_TEXTURE && (active->refuseFramebuffers || active->refusedIsBound))
        return GL_FRAMEBUFFER_UNSUPPORTED;
    return active->real.CheckFramebufferStatus(target);
}

GLenum GLAD_API_PTR getError()
{
    ++active->errorsAsked;
    if (active->nextError != GL_NO_ERROR && active->errorAfter-- <= 0)
        return active->errorStays
                   ? active->nextError
                   : std::exchange(active->nextError, static_cast<GLenum>(GL_NO_ERROR));
    return active->real.GetError();
}

void GLAD_API_PTR drawElements(GLenum mode, GLsizei n, GLenum type, const void* indices)
{
    const GladGLContext& gl = active->real;
    if (!active->countSamples) return gl.DrawElements(mode, n, type, indices);
    GLuint query = 0, samples = 0;
    gl.GenQueries(1, &query);
    gl.BeginQuery(GL_SAMPLES_PASSED, query);
    gl.DrawElements(mode, n, type, indices);
    gl.EndQuery(GL_SAMPLES_PASSED);
    gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
    gl.DeleteQueries(1, &query);
    active->samples.push_back(samples);
}

void GLAD_API_PTR texImage2D(GLenum target, GLint level, GLint internal, GLsizei width,
                             GLsizei height, GLint border, GLenum format, GLenum type,
                             const void* texels)
{
    const GladGLContext& gl = active->real;
    gl.TexImage2D(target, level, internal, width, height, border, format, type, texels);
    active->refusedIsBound = active->refusedFormat != 0 && internal == active->refusedFormat;
    if (internal != active->unfilteredFormat || target != GL_TEXTURE_2D) return;
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

GLboolean GLAD_API_PTR isEnabled(GLenum name)
{
    const GladGLContext& gl = active->real;
    const bool indexed = name == GL_BLEND || name == GL_SCISSOR_TEST;
    if (!active->coarseQueries || !indexed || !gl.VERSION_4_1) return gl.IsEnabled(name);
    GLboolean any = GL_FALSE;
    for (GLuint i = 0; i < 2; ++i) any |= gl.IsEnabledi(name, i);
    return any;
}

void GLAD_API_PTR getDoublev(GLenum name, GLdouble* values)
{
    active->real.GetDoublev(name, values);
    if (!active->coarseQueries || name != GL_DEPTH_RANGE) return;
    for (int i = 0; i < 2; ++i) values[i] = static_cast<GLdouble>(static_cast<GLfloat>(values[i]));
}

void GLAD_API_PTR getFloatv(GLenum name, GLfloat* values)
{
    active->real.GetFloatv(name, values);
    if (!active->coarseQueries || name != GL_VIEWPORT) return;
    for (int i = 0; i < 4; ++i) values[i] = std::floor(values[i]);
}

template <class Function>
void* pointer(Function function)
{
    return reinterpret_cast<void*>(function);
}

void* hooked(const std::string& name)
{
    static const std::map<std::string, void*> functions{
        {"glGenTextures", pointer(genTextures)},
        {"glDeleteTextures", pointer(deleteTextures)},
        {"glGenBuffers", pointer(genBuffers)},
        {"glDeleteBuffers", pointer(deleteBuffers)},
        {"glGenVertexArrays", pointer(genVertexArrays)},
        {"glDeleteVertexArrays", pointer(deleteVertexArrays)},
        {"glGenFramebuffers", pointer(genFramebuffers)},
        {"glDeleteFramebuffers", pointer(deleteFramebuffers)},
        {"glGenRenderbuffers", pointer(genRenderbuffers)},
        {"glDeleteRenderbuffers", pointer(deleteRenderbuffers)},
        {"glCreateShader", pointer(createShader)},
        {"glDeleteShader", pointer(deleteShader)},
        {"glCreateProgram", pointer(createProgram)},
        {"glDeleteProgram", pointer(deleteProgram)},
        {"glShaderSource", pointer(shaderSource)},
        {"glLinkProgram", pointer(linkProgram)},
        {"glCheckFramebufferStatus", pointer(checkFramebufferStatus)},
        {"glGetError", pointer(getError)},
        {"glDrawElements", pointer(drawElements)},
        {"glTexImage2D", pointer(texImage2D)},
        {"glIsEnabled", pointer(isEnabled)},
        {"glGetDoublev", pointer(getDoublev)},
        {"glGetFloatv", pointer(getFloatv)},
    };
    const auto found = functions.find(name);
    return found == functions.end() ? nullptr : found->second;
}

HeadlessContext::Load realLoad = nullptr;

}  // namespace

Hooks::Hooks(HeadlessContext::Load loader) : real(loadGl(loader))
{
    if (active) throw std::logic_error("one Hooks at a time");
    active = this;
    realLoad = loader;
}

Hooks::~Hooks()
{
    active = nullptr;
}

void* Hooks::load(void* user, const char* name)
{
    Hooks& hooks = *static_cast<Hooks*>(user);
    hooks.asked.insert(name);
    if (hooks.hidden.count(name)) return nullptr;
    void* const replacement = hooked(name);
    return replacement ? replacement : realLoad(nullptr, name);
}

}  // namespace fbrdf::test

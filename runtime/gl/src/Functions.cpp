#define GLAD_GL_IMPLEMENTATION
#include "Functions.h"

#include <fbrdf/brdf/Error.h>

#include <cstring>

namespace fbrdf::gl {
namespace {

struct Loader {
    LoadFunction load;
    void* user;
};

[[noreturn]] void fail(const std::string& what)
{
    throw Error(ErrorKind::gl, "OpenGL", what);
}

// What this library calls, and when. eglGetProcAddress returns a pointer for any name, so a pointer
// proves nothing; but a null one proves that a call would crash.
void checkAll(const Functions& gl)
{
    const bool always = true, gl30 = gl.version >= 30, gl33 = gl.version >= 33,
               gl40 = gl.version >= 40, gl41 = gl.version >= 41, gl45 = gl.version >= 45,
               framebuffers = gl30 || gl.ARB_framebuffer_object,
               vertexArrays = gl30 || gl.ARB_vertex_array_object;
#define FBRDF_NEEDS(when, name)                                                                  \
    if (when && !gl.name)                                                                        \
        fail("found no gl" #name " in a context of version " + std::to_string(gl.version / 10) + \
             "." + std::to_string(gl.version % 10) + ", expected one");
    FBRDF_NEEDS(always, ActiveTexture)
    FBRDF_NEEDS(always, AttachShader)
    FBRDF_NEEDS(always, BindAttribLocation)
    FBRDF_NEEDS(always, BindBuffer)
    FBRDF_NEEDS(always, BindTexture)
    FBRDF_NEEDS(always, BlendEquationSeparate)
    FBRDF_NEEDS(always, BlendFuncSeparate)
    FBRDF_NEEDS(always, BufferData)
    FBRDF_NEEDS(always, BufferSubData)
    FBRDF_NEEDS(always, Clear)
    FBRDF_NEEDS(always, ClearDepth)
    FBRDF_NEEDS(always, ColorMask)
    FBRDF_NEEDS(always, CompileShader)
    FBRDF_NEEDS(always, CreateProgram)
    FBRDF_NEEDS(always, CreateShader)
    FBRDF_NEEDS(always, DeleteBuffers)
    FBRDF_NEEDS(always, DeleteProgram)
    FBRDF_NEEDS(always, DeleteShader)
    FBRDF_NEEDS(always, DeleteTextures)
    FBRDF_NEEDS(always, DepthFunc)
    FBRDF_NEEDS(always, DepthMask)
    FBRDF_NEEDS(always, DepthRange)
    FBRDF_NEEDS(always, Disable)
    FBRDF_NEEDS(always, DisableVertexAttribArray)
    FBRDF_NEEDS(always, DrawElements)
    FBRDF_NEEDS(always, Enable)
    FBRDF_NEEDS(always, EnableVertexAttribArray)
    FBRDF_NEEDS(always, GenBuffers)
    FBRDF_NEEDS(always, GenTextures)
    FBRDF_NEEDS(always, GetActiveUniform)
    FBRDF_NEEDS(always, GetBooleanv)
    FBRDF_NEEDS(always, GetDoublev)
    FBRDF_NEEDS(always, GetError)
    FBRDF_NEEDS(always, GetFloatv)
    FBRDF_NEEDS(always, GetIntegerv)
    FBRDF_NEEDS(always, GetProgramInfoLog)
    FBRDF_NEEDS(always, GetProgramiv)
    FBRDF_NEEDS(always, GetShaderInfoLog)
    FBRDF_NEEDS(always, GetShaderiv)
    FBRDF_NEEDS(always, GetString)
    FBRDF_NEEDS(always, GetUniformLocation)
    FBRDF_NEEDS(always, GetVertexAttribPointerv)
    FBRDF_NEEDS(always, GetVertexAttribiv)
    FBRDF_NEEDS(always, IsEnabled)
    FBRDF_NEEDS(always, IsProgram)
    FBRDF_NEEDS(always, LinkProgram)
    FBRDF_NEEDS(always, PixelStorei)
    FBRDF_NEEDS(always, PolygonMode)
    FBRDF_NEEDS(always, ShaderSource)
    FBRDF_NEEDS(always, TexImage2D)
    FBRDF_NEEDS(always, TexImage3D)
    FBRDF_NEEDS(always, TexParameteri)
    FBRDF_NEEDS(always, Uniform1i)
    FBRDF_NEEDS(always, Uniform2f)
    FBRDF_NEEDS(always, Uniform3fv)
    FBRDF_NEEDS(always, Uniform4fv)
    FBRDF_NEEDS(always, UniformMatrix3fv)
    FBRDF_NEEDS(always, UniformMatrix4fv)
    FBRDF_NEEDS(always, UseProgram)
    FBRDF_NEEDS(always, VertexAttribPointer)
    FBRDF_NEEDS(always, Viewport)
    FBRDF_NEEDS(framebuffers, BindFramebuffer)
    FBRDF_NEEDS(framebuffers, BindRenderbuffer)
    FBRDF_NEEDS(vertexArrays, BindVertexArray)
    FBRDF_NEEDS(framebuffers, CheckFramebufferStatus)
    FBRDF_NEEDS(gl30, ClampColor)
    FBRDF_NEEDS(gl30, ColorMaski)
    FBRDF_NEEDS(framebuffers, DeleteFramebuffers)
    FBRDF_NEEDS(framebuffers, DeleteRenderbuffers)
    FBRDF_NEEDS(vertexArrays, DeleteVertexArrays)
    FBRDF_NEEDS(gl30, Disablei)
    FBRDF_NEEDS(gl30, Enablei)
    FBRDF_NEEDS(framebuffers, FramebufferRenderbuffer)
    FBRDF_NEEDS(framebuffers, FramebufferTexture2D)
    FBRDF_NEEDS(framebuffers, GenFramebuffers)
    FBRDF_NEEDS(framebuffers, GenRenderbuffers)
    FBRDF_NEEDS(vertexArrays, GenVertexArrays)
    FBRDF_NEEDS(gl30, GetBooleani_v)
    FBRDF_NEEDS(framebuffers, GetFramebufferAttachmentParameteriv)
    FBRDF_NEEDS(framebuffers, RenderbufferStorage)
    FBRDF_NEEDS(gl33, BindSampler)
    FBRDF_NEEDS(gl40, BlendEquationSeparatei)
    FBRDF_NEEDS(gl40, BlendFuncSeparatei)
    FBRDF_NEEDS(gl41, DepthRangeIndexed)
    FBRDF_NEEDS(gl41, ViewportIndexedf)
    FBRDF_NEEDS(gl45, ClipControl)
#undef FBRDF_NEEDS
}

}  // namespace

Functions loadFunctions(LoadFunction load, void* user)
{
    if (!load) fail("found no loader, expected a function that returns GL functions by name");
    Functions gl{};
    Loader loader{load, user};
    const auto byName = [](void* context, const char* name) {
        const Loader& l = *static_cast<Loader*>(context);
        return reinterpret_cast<GLADapiproc>(l.load(l.user, name));
    };
    const int version = gladLoadGLContextUserPtr(&gl, byName, &loader);
    if (version == 0)
        fail(
            "found no current context or a loader that yields nothing, expected OpenGL 2.1 or "
            "newer");
    const std::string text = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
    gl.version = 10 * GLAD_VERSION_MAJOR(version) + GLAD_VERSION_MINOR(version);
    if (text.compare(0, 9, "OpenGL ES") == 0 || gl.version < 21)
        fail("found version '" + text + "', expected OpenGL 2.1 or newer");
    checkAll(gl);
    return gl;
}

}  // namespace fbrdf::gl

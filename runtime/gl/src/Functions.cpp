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

// What this library calls, and the version from which on it is called. eglGetProcAddress returns a
// pointer for any name, so a pointer proves nothing; but a null one proves that a call would crash.
void checkAll(const Functions& gl)
{
#define FBRDF_NEEDS(since, name)         \
    if (gl.version >= since && !gl.name) \
        fail("found no gl" #name ", expected one from version " #since " / 10 on");
    FBRDF_NEEDS(21, ActiveTexture)
    FBRDF_NEEDS(21, AttachShader)
    FBRDF_NEEDS(21, BindAttribLocation)
    FBRDF_NEEDS(21, BindBuffer)
    FBRDF_NEEDS(21, BindTexture)
    FBRDF_NEEDS(21, BlendEquationSeparate)
    FBRDF_NEEDS(21, BlendFuncSeparate)
    FBRDF_NEEDS(21, BufferData)
    FBRDF_NEEDS(21, BufferSubData)
    FBRDF_NEEDS(21, Clear)
    FBRDF_NEEDS(21, ClearDepth)
    FBRDF_NEEDS(21, ColorMask)
    FBRDF_NEEDS(21, CompileShader)
    FBRDF_NEEDS(21, CreateProgram)
    FBRDF_NEEDS(21, CreateShader)
    FBRDF_NEEDS(21, DeleteBuffers)
    FBRDF_NEEDS(21, DeleteProgram)
    FBRDF_NEEDS(21, DeleteShader)
    FBRDF_NEEDS(21, DeleteTextures)
    FBRDF_NEEDS(21, DepthFunc)
    FBRDF_NEEDS(21, DepthMask)
    FBRDF_NEEDS(21, DepthRange)
    FBRDF_NEEDS(21, Disable)
    FBRDF_NEEDS(21, DisableVertexAttribArray)
    FBRDF_NEEDS(21, DrawElements)
    FBRDF_NEEDS(21, Enable)
    FBRDF_NEEDS(21, EnableVertexAttribArray)
    FBRDF_NEEDS(21, GenBuffers)
    FBRDF_NEEDS(21, GenTextures)
    FBRDF_NEEDS(21, GetActiveUniform)
    FBRDF_NEEDS(21, GetBooleanv)
    FBRDF_NEEDS(21, GetDoublev)
    FBRDF_NEEDS(21, GetError)
    FBRDF_NEEDS(21, GetFloatv)
    FBRDF_NEEDS(21, GetIntegerv)
    FBRDF_NEEDS(21, GetProgramInfoLog)
    FBRDF_NEEDS(21, GetProgramiv)
    FBRDF_NEEDS(21, GetShaderInfoLog)
    FBRDF_NEEDS(21, GetShaderiv)
    FBRDF_NEEDS(21, GetString)
    FBRDF_NEEDS(21, GetUniformLocation)
    FBRDF_NEEDS(21, GetVertexAttribPointerv)
    FBRDF_NEEDS(21, GetVertexAttribiv)
    FBRDF_NEEDS(21, IsEnabled)
    FBRDF_NEEDS(21, IsProgram)
    FBRDF_NEEDS(21, LinkProgram)
    FBRDF_NEEDS(21, PixelStorei)
    FBRDF_NEEDS(21, PolygonMode)
    FBRDF_NEEDS(21, ShaderSource)
    FBRDF_NEEDS(21, TexImage2D)
    FBRDF_NEEDS(21, TexImage3D)
    FBRDF_NEEDS(21, TexParameteri)
    FBRDF_NEEDS(21, Uniform1i)
    FBRDF_NEEDS(21, Uniform2f)
    FBRDF_NEEDS(21, Uniform3fv)
    FBRDF_NEEDS(21, Uniform4fv)
    FBRDF_NEEDS(21, UniformMatrix3fv)
    FBRDF_NEEDS(21, UniformMatrix4fv)
    FBRDF_NEEDS(21, UseProgram)
    FBRDF_NEEDS(21, VertexAttribPointer)
    FBRDF_NEEDS(21, Viewport)
    FBRDF_NEEDS(30, BindFramebuffer)
    FBRDF_NEEDS(30, BindRenderbuffer)
    FBRDF_NEEDS(30, BindVertexArray)
    FBRDF_NEEDS(30, CheckFramebufferStatus)
    FBRDF_NEEDS(30, ColorMaski)
    FBRDF_NEEDS(30, DeleteFramebuffers)
    FBRDF_NEEDS(30, DeleteRenderbuffers)
    FBRDF_NEEDS(30, DeleteVertexArrays)
    FBRDF_NEEDS(30, Disablei)
    FBRDF_NEEDS(30, Enablei)
    FBRDF_NEEDS(30, FramebufferRenderbuffer)
    FBRDF_NEEDS(30, FramebufferTexture2D)
    FBRDF_NEEDS(30, GenFramebuffers)
    FBRDF_NEEDS(30, GenRenderbuffers)
    FBRDF_NEEDS(30, GenVertexArrays)
    FBRDF_NEEDS(30, GetBooleani_v)
    FBRDF_NEEDS(30, GetFramebufferAttachmentParameteriv)
    FBRDF_NEEDS(30, GetIntegeri_v)
    FBRDF_NEEDS(30, IsEnabledi)
    FBRDF_NEEDS(30, RenderbufferStorage)
    FBRDF_NEEDS(33, BindSampler)
    FBRDF_NEEDS(40, BlendEquationSeparatei)
    FBRDF_NEEDS(40, BlendFuncSeparatei)
    FBRDF_NEEDS(41, DepthRangeIndexed)
    FBRDF_NEEDS(41, GetDoublei_v)
    FBRDF_NEEDS(41, GetFloati_v)
    FBRDF_NEEDS(41, ViewportIndexedf)
    FBRDF_NEEDS(45, ClipControl)
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

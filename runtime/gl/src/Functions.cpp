#define GLAD_GL_IMPLEMENTATION
#include "Functions.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <cstring>
#include <type_traits>

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

// The functions that this library calls, and in which contexts. eglGetProcAddress returns a pointer
// for any name, so a pointer proves nothing; but a null one proves that a call would crash.
#define FBRDF_NEEDS(when, name)                                                                  \
    if (when && !gl.name)                                                                        \
        fail(Found("no gl" #name " in a context of version " + std::to_string(gl.version / 10) + \
                   "." + std::to_string(gl.version % 10))                                        \
                 .expected("one"));

// What every context has, of whatever version, is checked without a condition.
void checkPrograms(const Functions& gl)
{
    FBRDF_NEEDS(true, AttachShader)
    FBRDF_NEEDS(true, BindAttribLocation)
    FBRDF_NEEDS(true, CompileShader)
    FBRDF_NEEDS(true, CreateProgram)
    FBRDF_NEEDS(true, CreateShader)
    FBRDF_NEEDS(true, DeleteProgram)
    FBRDF_NEEDS(true, DeleteShader)
    FBRDF_NEEDS(true, GetActiveUniform)
    FBRDF_NEEDS(true, GetAttribLocation)
    FBRDF_NEEDS(true, GetProgramInfoLog)
    FBRDF_NEEDS(true, GetProgramiv)
    FBRDF_NEEDS(true, GetShaderInfoLog)
    FBRDF_NEEDS(true, GetShaderiv)
    FBRDF_NEEDS(true, GetUniformLocation)
    FBRDF_NEEDS(true, IsProgram)
    FBRDF_NEEDS(true, LinkProgram)
    FBRDF_NEEDS(true, ShaderSource)
    FBRDF_NEEDS(true, Uniform1f)
    FBRDF_NEEDS(true, Uniform1i)
    FBRDF_NEEDS(true, Uniform1iv)
    FBRDF_NEEDS(true, Uniform2f)
    FBRDF_NEEDS(true, Uniform3fv)
    FBRDF_NEEDS(true, Uniform4fv)
    FBRDF_NEEDS(true, UniformMatrix3fv)
    FBRDF_NEEDS(true, UniformMatrix4fv)
    FBRDF_NEEDS(true, UseProgram)
}

void checkBasics(const Functions& gl)
{
    FBRDF_NEEDS(true, ActiveTexture)
    FBRDF_NEEDS(true, BindBuffer)
    FBRDF_NEEDS(true, BindTexture)
    FBRDF_NEEDS(true, BlendEquationSeparate)
    FBRDF_NEEDS(true, BlendFuncSeparate)
    FBRDF_NEEDS(true, BufferData)
    FBRDF_NEEDS(true, BufferSubData)
    FBRDF_NEEDS(true, Clear)
    FBRDF_NEEDS(!gl.es, ClearDepth)
    FBRDF_NEEDS(true, ColorMask)
    FBRDF_NEEDS(true, DeleteBuffers)
    FBRDF_NEEDS(true, DeleteTextures)
    FBRDF_NEEDS(true, DepthFunc)
    FBRDF_NEEDS(true, DepthMask)
    FBRDF_NEEDS(!gl.es, DepthRange)
    FBRDF_NEEDS(true, Disable)
    FBRDF_NEEDS(true, DisableVertexAttribArray)
    FBRDF_NEEDS(true, DrawElements)
    FBRDF_NEEDS(true, Enable)
    FBRDF_NEEDS(true, EnableVertexAttribArray)
    FBRDF_NEEDS(true, GenBuffers)
    FBRDF_NEEDS(true, GenTextures)
    FBRDF_NEEDS(true, GetBooleanv)
    FBRDF_NEEDS(true, GetBufferParameteriv)
    FBRDF_NEEDS(!gl.es, GetBufferSubData)
    FBRDF_NEEDS(!gl.es, GetDoublev)
    FBRDF_NEEDS(!gl.es, GetTexLevelParameteriv)
    FBRDF_NEEDS(true, GetError)
    FBRDF_NEEDS(true, GetFloatv)
    FBRDF_NEEDS(true, GetIntegerv)
    FBRDF_NEEDS(true, GetString)
    FBRDF_NEEDS(true, GetVertexAttribPointerv)
    FBRDF_NEEDS(true, GetVertexAttribfv)
    FBRDF_NEEDS(true, GetVertexAttribiv)
    FBRDF_NEEDS(true, IsBuffer)
    FBRDF_NEEDS(true, IsEnabled)
    FBRDF_NEEDS(true, IsTexture)
    FBRDF_NEEDS(true, PixelStorei)
    FBRDF_NEEDS(!gl.es, PolygonMode)
    FBRDF_NEEDS(true, ReadPixels)
    FBRDF_NEEDS(true, TexImage2D)
    FBRDF_NEEDS(gl.hasVolumes(), TexImage3D)
    FBRDF_NEEDS(true, TexParameteri)
    FBRDF_NEEDS(true, VertexAttrib4f)
    FBRDF_NEEDS(true, VertexAttribPointer)
    FBRDF_NEEDS(true, Viewport)
}

// Conditions are those under which this library calls the function, which may be narrower than
// those under which GL has it.
void checkNewer(const Functions& gl)
{
    const bool es = gl.es != 0, es30 = gl.es >= 30, gl30 = gl.version >= 30,
               gl31 = gl.version >= 31, gl40 = gl.version >= 40, gl41 = gl.version >= 41,
               framebuffers = gl30 || es || gl.ARB_framebuffer_object,
               vertexArrays = gl30 || es30 || gl.ARB_vertex_array_object;
    FBRDF_NEEDS(framebuffers, BindFramebuffer)
    FBRDF_NEEDS(framebuffers, BindRenderbuffer)
    FBRDF_NEEDS(vertexArrays, BindVertexArray)
    FBRDF_NEEDS(framebuffers, CheckFramebufferStatus)
    FBRDF_NEEDS(gl30, BlitFramebuffer)
    FBRDF_NEEDS(gl30, ClampColor)
    FBRDF_NEEDS(gl30, ClearBufferfv)
    FBRDF_NEEDS(gl30, ColorMaski)
    FBRDF_NEEDS(framebuffers, DeleteFramebuffers)
    FBRDF_NEEDS(framebuffers, DeleteRenderbuffers)
    FBRDF_NEEDS(vertexArrays, DeleteVertexArrays)
    FBRDF_NEEDS(gl30, Disablei)
    FBRDF_NEEDS(gl30, Enablei)
    FBRDF_NEEDS(framebuffers, FramebufferRenderbuffer)
    FBRDF_NEEDS(framebuffers, FramebufferTexture2D)
    FBRDF_NEEDS(framebuffers, GenFramebuffers)
    FBRDF_NEEDS(framebuffers, GenerateMipmap)
    FBRDF_NEEDS(framebuffers, GenRenderbuffers)
    FBRDF_NEEDS(vertexArrays, GenVertexArrays)
    FBRDF_NEEDS(gl30, GetBooleani_v)
    FBRDF_NEEDS(gl30, GetIntegeri_v)
    FBRDF_NEEDS(gl30, IsEnabledi)
    FBRDF_NEEDS(es, ClearDepthf)
    FBRDF_NEEDS(es, DepthRangef)
    FBRDF_NEEDS(framebuffers, GetFramebufferAttachmentParameteriv)
    FBRDF_NEEDS(framebuffers, IsFramebuffer)
    FBRDF_NEEDS(framebuffers, RenderbufferStorage)
    FBRDF_NEEDS(gl30, RenderbufferStorageMultisample)
    FBRDF_NEEDS(gl.hasArrays(), TexSubImage3D)
    FBRDF_NEEDS(gl.has(30, 30), GetStringi)
    FBRDF_NEEDS(gl31, DrawElementsInstanced)
    FBRDF_NEEDS(gl31, TexBuffer)
    FBRDF_NEEDS(gl31, Uniform3i)
    FBRDF_NEEDS(gl.hasSamplers(), BindSampler)
    FBRDF_NEEDS(gl40, BlendEquationSeparatei)
    FBRDF_NEEDS(gl40, BlendFuncSeparatei)
    FBRDF_NEEDS(gl41, DepthRangeIndexed)
    FBRDF_NEEDS(gl41, GetDoublei_v)
    FBRDF_NEEDS(gl41, GetFloati_v)
    FBRDF_NEEDS(gl41, ViewportIndexedf)
    FBRDF_NEEDS(gl.hasClipControl, ClipControl)
}
#undef FBRDF_NEEDS

/// Finds the functions of OpenGL ES that glad looks for in later desktop versions only.
void loadEmbedded(Functions& gl, const Loader& loader)
{
    const auto find = [&loader](auto& function, const char* name) {
        if (!function)
            function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
                loader.load(loader.user, name));
    };
#define FBRDF_FIND(name) find(gl.name, "gl" #name);
    FBRDF_FIND(BindFramebuffer)
    FBRDF_FIND(BindRenderbuffer)
    FBRDF_FIND(CheckFramebufferStatus)
    FBRDF_FIND(ClearDepthf)
    FBRDF_FIND(DeleteFramebuffers)
    FBRDF_FIND(DeleteRenderbuffers)
    FBRDF_FIND(DepthRangef)
    FBRDF_FIND(FramebufferRenderbuffer)
    FBRDF_FIND(FramebufferTexture2D)
    FBRDF_FIND(GenFramebuffers)
    FBRDF_FIND(GenerateMipmap)
    FBRDF_FIND(GenRenderbuffers)
    FBRDF_FIND(GetFramebufferAttachmentParameteriv)
    FBRDF_FIND(IsFramebuffer)
    FBRDF_FIND(RenderbufferStorage)
    if (gl.es < 30) return;
    FBRDF_FIND(BindSampler)
#undef FBRDF_FIND
}

/// OpenGL ES has the function under another name, with the same enumerators.
void findClipControl(Functions& gl, const Loader& loader)
{
    gl.hasClipControl = gl.version >= 45 || gl.ARB_clip_control;
    if (gl.es == 0) return;
    gl.hasClipControl = gl.hasExtension("GL_EXT_clip_control");
    if (gl.hasClipControl)
        // The pointer takes the place of the desktop's, and callers need not know.
        gl.ClipControl =
            reinterpret_cast<PFNGLCLIPCONTROLPROC>(loader.load(loader.user, "glClipControlEXT"));
}

}  // namespace

bool Functions::hasExtension(const char* name) const
{
    // Contexts before 3.0 list all extensions in one text; core profiles no longer have that text.
    // Blanks around both keep a name from matching the beginning of a longer one.
    if (!has(30, 30)) {
        const auto* all = reinterpret_cast<const char*>(GetString(GL_EXTENSIONS));
        return all && (" " + std::string(all) + " ").find(" " + std::string(name) + " ") !=
                          std::string::npos;
    }
    GLint count = 0;
    GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* one =
            reinterpret_cast<const char*>(GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
        if (one && std::strcmp(one, name) == 0) return true;
    }
    return false;
}

Functions loadFunctions(LoadFunction load, void* user)
{
    if (!load) fail(Found("no loader").expected("a function that returns GL functions by name"));
    Functions gl{};
    Loader loader{load, user};
    const auto byName = [](void* context, const char* name) {
        const Loader& l = *static_cast<Loader*>(context);
        return reinterpret_cast<GLADapiproc>(l.load(l.user, name));
    };
    const int version = gladLoadGLContextUserPtr(&gl, byName, &loader);
    if (version == 0)
        fail(Found("no current context or a loader that yields nothing")
                 .expected("OpenGL 2.1 or newer"));
    const std::string text = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
    gl.version = 10 * GLAD_VERSION_MAJOR(version) + GLAD_VERSION_MINOR(version);
    if (text.compare(0, 9, "OpenGL ES") == 0) {
        // Desktop 2.1 is what ES 2.0 can do, so that a test for a desktop version fails in ES
        // unless it asks for ES as well (Functions::has).
        gl.es = gl.version;
        gl.version = 21;
        loadEmbedded(gl, loader);
    }
    if (gl.version < 21 || (gl.es != 0 && gl.es < 20))
        fail(Found("version '" + text + "'").expected("OpenGL 2.1 or OpenGL ES 2.0 or newer"));
    checkBasics(gl);
    checkPrograms(gl);
    // checkNewer asks for glClipControl, so it has to be found first.
    findClipControl(gl, loader);
    checkNewer(gl);
    return gl;
}

}  // namespace fbrdf::gl

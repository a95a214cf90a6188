#define GLAD_GL_IMPLEMENTATION
#include "GlFunctions.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

namespace fbrdf::viewer {

GladGLContext loadGlFunctions(gl::LoadFunction load)
{
    GladGLContext functions{};
    const auto loadOne = [](void* user, const char* name) {
        return reinterpret_cast<GLADapiproc>(
            (*static_cast<gl::LoadFunction*>(user))(nullptr, name));
    };
    if (!gladLoadGLContextUserPtr(&functions, loadOne, &load))
        throw Error(ErrorKind::gl, "viewer", Found("no current context").expected("OpenGL 3.3"));
    return functions;
}

void setFloatTexture(const GladGLContext& gl, GLuint texture, int width, int height,
                     const float* rgba, GLint format)
{
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl.TexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA, GL_FLOAT, rgba);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.BindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace fbrdf::viewer

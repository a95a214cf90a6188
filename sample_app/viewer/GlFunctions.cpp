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

}  // namespace fbrdf::viewer

#define GLAD_GL_IMPLEMENTATION
#include <glad/gl.h>
#undef GLAD_GL_IMPLEMENTATION  // a second inclusion would define everything again
#include "Gl.h"

#include <stdexcept>
#include <string>

namespace fbrdf::test {
GladGLContext loadGl(HeadlessContext::Load load)
{
    GladGLContext gl{};
    const auto byName = [](void* user, const char* name) {
        return reinterpret_cast<GLADapiproc>(
            (*static_cast<HeadlessContext::Load*>(user))(nullptr, name));
    };
    if (!gladLoadGLContextUserPtr(&gl, byName, &load)) throw std::runtime_error("no GL context");
    return gl;
}

}  // namespace fbrdf::test

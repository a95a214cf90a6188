#define GLAD_GL_IMPLEMENTATION
#include <glad/gl.h>
#undef GLAD_GL_IMPLEMENTATION  // a second inclusion would define everything again
#include "Gl.h"

#include <stdexcept>
#include <string>
#include <type_traits>

namespace fbrdf::test {
namespace {

/// Fills in functions of OpenGL ES 3.0 that glad only looks for in later desktop versions.
void loadEmbedded(GladGLContext& gl, HeadlessContext::Load load)
{
    const auto find = [load](auto& function, const char* name) {
        if (!function)
            function =
                reinterpret_cast<std::remove_reference_t<decltype(function)>>(load(nullptr, name));
    };
    find(gl.BindSampler, "glBindSampler");
    find(gl.ClearDepthf, "glClearDepthf");
    find(gl.DeleteSamplers, "glDeleteSamplers");
    find(gl.DepthRangef, "glDepthRangef");
    find(gl.GenSamplers, "glGenSamplers");
}

}  // namespace

GladGLContext loadGl(HeadlessContext::Load load)
{
    GladGLContext gl{};
    const auto byName = [](void* user, const char* name) {
        return reinterpret_cast<GLADapiproc>(
            (*static_cast<HeadlessContext::Load*>(user))(nullptr, name));
    };
    if (!gladLoadGLContextUserPtr(&gl, byName, &load)) throw std::runtime_error("no GL context");
    const std::string version = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
    if (version.rfind("OpenGL ES", 0) == 0) loadEmbedded(gl, load);
    return gl;
}

}  // namespace fbrdf::test

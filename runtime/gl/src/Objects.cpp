#include "Objects.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

namespace fbrdf::gl {
namespace {

// Labels take one set of names for kinds of objects, GL has no other use of it.
GLenum identifierOf(ObjectKind kind)
{
    switch (kind) {
        case ObjectKind::buffer: return GL_BUFFER;
        case ObjectKind::texture: return GL_TEXTURE;
        case ObjectKind::vertexArray: return GL_VERTEX_ARRAY;
        case ObjectKind::framebuffer: return GL_FRAMEBUFFER;
        case ObjectKind::renderbuffer: return GL_RENDERBUFFER;
        case ObjectKind::shader: return GL_SHADER;
        case ObjectKind::program: return GL_PROGRAM;
    }
    return GL_NONE;
}

}  // namespace

void Object::reset() noexcept
{
    // Names of an abandoned context may belong to other objects of a new one by now.
    const GLuint name = std::exchange(name_, 0u);
    if (name == 0 || !device_->alive) return;
    const Functions& gl = device_->gl;
    switch (kind_) {
        case ObjectKind::buffer: gl.DeleteBuffers(1, &name); break;
        case ObjectKind::texture: gl.DeleteTextures(1, &name); break;
        case ObjectKind::vertexArray: gl.DeleteVertexArrays(1, &name); break;
        case ObjectKind::framebuffer: gl.DeleteFramebuffers(1, &name); break;
        case ObjectKind::renderbuffer: gl.DeleteRenderbuffers(1, &name); break;
        case ObjectKind::shader: gl.DeleteShader(name); break;
        case ObjectKind::program: gl.DeleteProgram(name); break;
    }
}

Object createObject(const DevicePtr& device, ObjectKind kind)
{
    const Functions& gl = device->gl;
    GLuint name = 0;
    switch (kind) {
        case ObjectKind::buffer: gl.GenBuffers(1, &name); break;
        case ObjectKind::texture: gl.GenTextures(1, &name); break;
        case ObjectKind::vertexArray: gl.GenVertexArrays(1, &name); break;
        case ObjectKind::framebuffer: gl.GenFramebuffers(1, &name); break;
        case ObjectKind::renderbuffer: gl.GenRenderbuffers(1, &name); break;
        case ObjectKind::program: name = gl.CreateProgram(); break;
        // Shaders are made by compiledShader, which knows their stage.
        case ObjectKind::shader: break;
    }
    if (name == 0)
        throw Error(ErrorKind::gl, "OpenGL", Found("no name for a new object").expected("one"));
    return Object(device, kind, name);
}

void label(const Device& device, ObjectKind kind, const Object& object, const std::string& text)
{
    if (!device.capabilities.debug) return;
    const std::string name = ("fbrdf:" + text).substr(0, 255);  // GL_MAX_LABEL_LENGTH is 256
    device.gl.ObjectLabel(identifierOf(kind), object.name(), static_cast<GLsizei>(name.size()),
                          name.c_str());
}

}  // namespace fbrdf::gl

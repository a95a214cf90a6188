#include "CubePainter.h"

#include "Program.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/shaders/PrefilterSource.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>

namespace fbrdf::gl {
namespace {

/// Directions of increasing s and t, and the centre, of the faces +x -x +y -y +z -z (OpenGL 4.6,
/// table 8.19).
const glm::mat3 kFaceAxes[] = {
    {{0.0f, 0.0f, -1.0f}, {0.0f, -1.0f, 0.0f}, {1.0f, 0.0f, 0.0f}},
    {{0.0f, 0.0f, 1.0f}, {0.0f, -1.0f, 0.0f}, {-1.0f, 0.0f, 0.0f}},
    {{1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, {0.0f, 1.0f, 0.0f}},
    {{1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, {0.0f, -1.0f, 0.0f}},
    {{1.0f, 0.0f, 0.0f}, {0.0f, -1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}},
    {{-1.0f, 0.0f, 0.0f}, {0.0f, -1.0f, 0.0f}, {0.0f, 0.0f, -1.0f}},
};

}  // namespace

CubePainter::CubePainter(const DevicePtr& device, StateGuard& state, const MeshResources& triangle)
    : device_(device), state_(state), triangle_(triangle)
{
    const Functions& gl = device_->gl;
    framebuffer_ = createObject(device_, ObjectKind::framebuffer);
    gl.version >= 30 ? gl.Disablei(GL_BLEND, 0) : gl.Disable(GL_BLEND);
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_ALWAYS);
}

Object CubePainter::programOf(const std::string& fragment, const std::string& name) const
{
    const Object vertex = compiledShader(device_, GL_VERTEX_SHADER,
                                         prefilterVertexSource(device_->capabilities.glsl)),
                 shader = compiledShader(device_, GL_FRAGMENT_SHADER, fragment);
    Object program = linkedShaders(device_, vertex, shader, name);
    device_->gl.UseProgram(program.name());
    return program;
}

void CubePainter::setSampler(const Object& program, const char* name, int unit) const
{
    device_->gl.Uniform1i(device_->gl.GetUniformLocation(program.name(), name),
                          device_->firstTextureUnit + unit);
}

void CubePainter::draw(const Object& program, GLuint cube, const CubeRows& rows, float largest)
{
    const Functions& gl = device_->gl;
    const auto at = [&](const char* name) { return gl.GetUniformLocation(program.name(), name); };
    Target target;
    target.framebuffer = framebuffer_.name();
    target.width = target.height = rows.size;
    state_.setTarget(target);
    const PixelRect box{0, rows.first, rows.size, rows.count};
    state_.setScissor(rows.count < rows.size ? &box : nullptr);
    gl.Uniform1f(at("fbrdfFaceSize"), static_cast<GLfloat>(rows.size));
    gl.Uniform1f(at("fbrdfLargest"), largest);
    for (GLenum face = 0; face < 6; ++face) {
        gl.FramebufferTexture2D(gl.drawFramebuffer(), GL_COLOR_ATTACHMENT0,
                                GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, cube, rows.level);
        if (gl.CheckFramebufferStatus(gl.drawFramebuffer()) != GL_FRAMEBUFFER_COMPLETE)
            throw Error(
                ErrorKind::gl, "environment",
                Found("faces of a cube map that cannot be drawn to").expected("ones that can"));
        gl.UniformMatrix3fv(at("fbrdfFace"), 1, GL_FALSE, glm::value_ptr(kFaceAxes[face]));
        triangle_.draw(0);
    }
}

MeshData coveringTriangle()
{
    MeshData mesh;
    mesh.positions = {{-1.0f, -1.0f, 0.0f}, {3.0f, -1.0f, 0.0f}, {-1.0f, 3.0f, 0.0f}};
    mesh.normals.assign(3, {0.0f, 0.0f, 1.0f});
    mesh.indices = {0, 1, 2};
    return mesh;
}

}  // namespace fbrdf::gl

#include "Mesh.h"

#include "UploadGuard.h"

#include <fbrdf/brdf/Error.h>

#include <limits>

namespace fbrdf::gl {
namespace {

constexpr GLint kComponents = 3;

[[noreturn]] void fail(const std::string& what)
{
    throw Error(ErrorKind::input, "mesh", what);
}

void check(const MeshData& mesh)
{
    const size_t count = mesh.positions.size();
    if (mesh.normals.size() != count)
        fail("found " + std::to_string(mesh.normals.size()) + " normals, expected " +
             std::to_string(count));
    if (!mesh.tangents.empty() && mesh.tangents.size() != count)
        fail("found " + std::to_string(mesh.tangents.size()) + " tangents, expected none or " +
             std::to_string(count));
    if (mesh.indices.empty() || mesh.indices.size() % 3 != 0)
        fail("found " + std::to_string(mesh.indices.size()) +
             " indices, expected three a triangle");
    if (mesh.indices.size() > static_cast<size_t>(std::numeric_limits<GLsizei>::max()))
        fail("found " + std::to_string(mesh.indices.size()) + " indices, expected below 2^31");
    for (const uint32_t index : mesh.indices)
        if (index >= count)
            fail("found index " + std::to_string(index) + ", expected below " +
                 std::to_string(count));
}

/// About the middle of the box around the positions.
Sphere boundsOf(const MeshData& mesh)
{
    Vec3f low = mesh.positions.front(), high = low;
    for (const Vec3f& position : mesh.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    const Vec3f centre = 0.5f * (low + high);
    return {centre, glm::distance(centre, high)};
}

const void* offset(size_t bytes)
{
    return reinterpret_cast<const void*>(bytes);
}

}  // namespace

GpuMesh::GpuMesh(DevicePtr device, const MeshData& mesh) : device_(std::move(device))
{
    check(mesh);
    indexCount_ = static_cast<GLsizei>(mesh.indices.size());
    vertexCount_ = mesh.positions.size();
    hasTangents_ = !mesh.tangents.empty();
    bounds_ = boundsOf(mesh);
    upload(mesh);
}

void GpuMesh::upload(const MeshData& mesh)
{
    const Functions& gl = device_->gl;
    const UploadGuard guard(*device_);
    if (device_->capabilities.vertexArrays) {
        vertexArray_ = createObject(device_, ObjectKind::vertexArray);
        gl.BindVertexArray(vertexArray_.name());
        label(*device_, ObjectKind::vertexArray, vertexArray_, "mesh");
    }
    vertices_ = createObject(device_, ObjectKind::buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    const size_t bytes = vertexCount_ * sizeof(Vec3f);
    // Missing tangents are zeros, which the shader replaces by an arbitrary frame.
    const std::vector<Vec3f> none(hasTangents_ ? 0 : vertexCount_, Vec3f(0.0f));
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(kAttributeCount * bytes), nullptr,
                  GL_STATIC_DRAW);
    const Vec3f* const parts[] = {mesh.positions.data(), mesh.normals.data(),
                                  hasTangents_ ? mesh.tangents.data() : none.data()};
    for (size_t i = 0; i < kAttributeCount; ++i)
        gl.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(i * bytes),
                         static_cast<GLsizeiptr>(bytes), parts[i]);
    label(*device_, ObjectKind::buffer, vertices_, "mesh vertices");
    indices_ = createObject(device_, ObjectKind::buffer);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(uint32_t)),
                  mesh.indices.data(), GL_STATIC_DRAW);
    label(*device_, ObjectKind::buffer, indices_, "mesh indices");
    if (vertexArray_) setAttributes();
    checkErrors(*device_, "mesh");
}

void GpuMesh::setAttributes() const
{
    const Functions& gl = device_->gl;
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    for (GLuint i = 0; i < kAttributeCount; ++i) {
        gl.EnableVertexAttribArray(i);
        gl.VertexAttribPointer(i, kComponents, GL_FLOAT, GL_FALSE, 0,
                               offset(i * vertexCount_ * sizeof(Vec3f)));
    }
}

void GpuMesh::draw(int instances) const
{
    if (instances > 0)
        device_->gl.DrawElementsInstanced(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr,
                                          instances);
    else
        device_->gl.DrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

MeshBinding::MeshBinding(const GpuMesh& mesh) : mesh_(mesh)
{
    const Functions& gl = mesh.device_->gl;
    if (mesh.vertexArray_) {
        gl.BindVertexArray(mesh.vertexArray_.name());
        return;
    }
    if (mesh.device_->state == StateMode::restore) save();
    mesh.setAttributes();
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices_.name());
}

void MeshBinding::save()
{
    const Functions& gl = mesh_.device_->gl;
    elementBuffer_ = integer(gl, GL_ELEMENT_ARRAY_BUFFER_BINDING);
    for (GLuint i = 0; i < kAttributeCount; ++i) {
        SavedAttribute& a = saved_[i];
        gl.GetVertexAttribiv(i, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &a.enabled);
        gl.GetVertexAttribiv(i, GL_VERTEX_ATTRIB_ARRAY_SIZE, &a.size);
        gl.GetVertexAttribiv(i, GL_VERTEX_ATTRIB_ARRAY_TYPE, &a.type);
        gl.GetVertexAttribiv(i, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, &a.normalized);
        gl.GetVertexAttribiv(i, GL_VERTEX_ATTRIB_ARRAY_STRIDE, &a.stride);
        gl.GetVertexAttribiv(i, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &a.buffer);
        gl.GetVertexAttribPointerv(i, GL_VERTEX_ATTRIB_ARRAY_POINTER, &a.pointer);
    }
}

MeshBinding::~MeshBinding()
{
    if (mesh_.vertexArray_ || mesh_.device_->state == StateMode::leave) return;
    const Functions& gl = mesh_.device_->gl;
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLuint>(elementBuffer_));
    for (GLuint i = 0; i < kAttributeCount; ++i) {
        const SavedAttribute& a = saved_[i];
        gl.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(a.buffer));
        gl.VertexAttribPointer(i, a.size, static_cast<GLenum>(a.type),
                               a.normalized ? GL_TRUE : GL_FALSE, a.stride, a.pointer);
        if (!a.enabled) gl.DisableVertexAttribArray(i);
    }
}

}  // namespace fbrdf::gl

#include "Mesh.h"

#include "UploadGuard.h"

#include <fbrdf/base/Error.h>

#include <limits>

namespace fbrdf::gl {
namespace {

[[noreturn]] void fail(const std::string& what)
{
    throw Error(ErrorKind::input, "mesh", what);
}

/// size: of an array that may be left out.
void checkOptional(size_t size, size_t count, const char* name)
{
    if (size != 0 && size != count)
        fail("found " + std::to_string(size) + " " + name + ", expected none or " +
             std::to_string(count));
}

void checkIndices(const MeshData& mesh)
{
    if (mesh.indices.empty() || mesh.indices.size() % 3 != 0)
        fail("found " + std::to_string(mesh.indices.size()) +
             " indices, expected three a triangle");
    if (mesh.indices.size() > static_cast<size_t>(std::numeric_limits<GLsizei>::max()))
        fail("found " + std::to_string(mesh.indices.size()) + " indices, expected below 2^31");
    for (const uint32_t index : mesh.indices)
        if (index >= mesh.positions.size())
            fail("found index " + std::to_string(index) + ", expected below " +
                 std::to_string(mesh.positions.size()));
}

void check(const MeshData& mesh)
{
    const size_t count = mesh.positions.size();
    if (mesh.normals.size() != count)
        fail("found " + std::to_string(mesh.normals.size()) + " normals, expected " +
             std::to_string(count));
    checkOptional(mesh.tangents.size(), count, "tangents");
    checkOptional(mesh.handedness.size(), mesh.tangents.size(), "signs of tangents");
    checkOptional(mesh.textureCoordinates.size(), count, "texture coordinates");
    if (mesh.extra.size() > kExtraArrays)
        fail("found " + std::to_string(mesh.extra.size()) + " extra arrays, expected at most " +
             std::to_string(kExtraArrays));
    for (const auto& array : mesh.extra)
        if (array.size() != count)
            fail("found an extra array of " + std::to_string(array.size()) + ", expected " +
                 std::to_string(count));
    checkIndices(mesh);
}

/// And handedness. Missing tangents are zeros, which the shader replaces by an arbitrary frame.
std::vector<glm::vec4> tangentsOf(const MeshData& mesh)
{
    std::vector<glm::vec4> tangents(mesh.positions.size(), {0.0f, 0.0f, 0.0f, 1.0f});
    for (size_t i = 0; i < mesh.tangents.size(); ++i)
        tangents[i] = {mesh.tangents[i], mesh.handedness.empty() ? 1.0f : mesh.handedness[i]};
    return tangents;
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
    if (!device_->wideIndices)
        throw Error(ErrorKind::gl, "mesh",
                    "found no 32-bit indices, expected OES_element_index_uint");
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
    uploadVertices(mesh);
    indices_ = createObject(device_, ObjectKind::buffer);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(uint32_t)),
                  mesh.indices.data(), GL_STATIC_DRAW);
    label(*device_, ObjectKind::buffer, indices_, "mesh indices");
    if (vertexArray_) setAttributes();
    checkErrors(*device_, "mesh");
}

/// One array after the other, those that the mesh has.
void GpuMesh::uploadVertices(const MeshData& mesh)
{
    const Functions& gl = device_->gl;
    std::vector<unsigned char> bytes;
    const auto append = [&](GLuint attribute, GLint components, const auto& array) {
        if (array.empty()) return;
        arrays_[attribute] = {components, bytes.size()};
        const auto* first = reinterpret_cast<const unsigned char*>(array.data());
        bytes.insert(bytes.end(), first, first + array.size() * sizeof array[0]);
    };
    append(kPosition, 3, mesh.positions);
    append(kNormal, 3, mesh.normals);
    append(kTangent, 4, tangentsOf(mesh));
    append(kTextureCoordinate, 2, mesh.textureCoordinates);
    for (size_t k = 0; k < mesh.extra.size(); ++k)
        append(static_cast<GLuint>(kExtra + k), 4, mesh.extra[k]);
    vertices_ = createObject(device_, ObjectKind::buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(),
                  GL_STATIC_DRAW);
    label(*device_, ObjectKind::buffer, vertices_, "mesh vertices");
}

void GpuMesh::setAttributes() const
{
    const Functions& gl = device_->gl;
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    for (GLuint i = 0; i < kAttributeCount; ++i) {
        if (!has(i)) {
            gl.DisableVertexAttribArray(i);
            continue;
        }
        gl.EnableVertexAttribArray(i);
        gl.VertexAttribPointer(i, arrays_[i].components, GL_FLOAT, GL_FALSE, 0,
                               offset(arrays_[i].offset));
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
        a.enabled ? gl.EnableVertexAttribArray(i) : gl.DisableVertexAttribArray(i);
    }
}

}  // namespace fbrdf::gl

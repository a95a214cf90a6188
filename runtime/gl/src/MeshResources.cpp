#include "MeshResources.h"

#include "UploadGuard.h"

#include <fbrdf/base/Assert.h>

namespace fbrdf::gl {
namespace {

const void* offset(size_t bytes)
{
    return reinterpret_cast<const void*>(bytes);
}

}  // namespace

MeshResources::MeshResources(DevicePtr device, const MeshData& mesh) : device_(std::move(device))
{
    const UploadGuard guard(*device_);
    bindVertexArray();
    // The vertex array comes first: the binding of the index buffer is part of it.
    arrays_ = uploadArrays(device_, mesh, storage_);
    if (vertexArray_) setAttributes();
    checkErrors(*device_, "mesh");
}

MeshResources::MeshResources(DevicePtr device, const MeshBuffers& mesh) : device_(std::move(device))
{
    const UploadGuard guard(*device_);
    // The vertex array comes last: binding a buffer to look at it must not change it.
    arrays_ = hostArrays(*device_, mesh);
    bindVertexArray();
    if (vertexArray_) {
        setAttributes();
        device_->gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, arrays_.indexBuffer);
    }
    checkErrors(*device_, "mesh");
}

void MeshResources::bindVertexArray()
{
    if (!device_->capabilities.vertexArrays) return;
    vertexArray_ = createObject(device_, ObjectKind::vertexArray);
    device_->gl.BindVertexArray(vertexArray_.name());
    label(*device_, ObjectKind::vertexArray, vertexArray_, "mesh");
}

void MeshResources::setAttributes() const
{
    const Functions& gl = device_->gl;
    // Without vertex arrays the host's attributes may be enabled, so missing ones are disabled.
    for (GLuint i = 0; i < kAttributeCount; ++i) {
        const MeshArrays::Array& array = arrays_.attributes[i];
        if (!has(i)) {
            gl.DisableVertexAttribArray(i);
            continue;
        }
        gl.BindBuffer(GL_ARRAY_BUFFER, array.buffer);
        gl.EnableVertexAttribArray(i);
        gl.VertexAttribPointer(i, array.components, GL_FLOAT, GL_FALSE, array.stride,
                               offset(array.offset));
    }
}

void MeshResources::draw(int instances) const
{
    FBRDF_ASSERT(instances, >=, 0);
    const Functions& gl = device_->gl;
    const MeshArrays& a = arrays_;
    // An instanced draw of one differs from a plain one: gl_InstanceID, and so the program.
    if (instances > 0)
        gl.DrawElementsInstanced(GL_TRIANGLES, a.indexCount, a.indexType, offset(a.indexOffset),
                                 instances);
    else
        gl.DrawElements(GL_TRIANGLES, a.indexCount, a.indexType, offset(a.indexOffset));
}

MeshBinding::MeshBinding(const MeshResources& mesh) : mesh_(mesh)
{
    const Functions& gl = mesh.device_->gl;
    if (!mesh.hasTangents()) setMissingTangent();
    // The vertex array knows all but the current value of a missing attribute.
    if (mesh.vertexArray_) {
        gl.BindVertexArray(mesh.vertexArray_.name());
        return;
    }
    if (mesh.device_->state == StateMode::restore) save();
    // Without vertex arrays the attributes are global state, set anew for each mesh and saved
    // before.
    mesh.setAttributes();
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.arrays_.indexBuffer);
}

// The shader replaces a tangent of zeros by an arbitrary frame.
void MeshBinding::setMissingTangent()
{
    const Functions& gl = mesh_.device_->gl;
    if (mesh_.device_->state == StateMode::restore)
        gl.GetVertexAttribfv(kTangent, GL_CURRENT_VERTEX_ATTRIB, tangent_);
    gl.VertexAttrib4f(kTangent, 0.0f, 0.0f, 0.0f, 1.0f);
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
    if (mesh_.device_->state == StateMode::leave) return;
    const Functions& gl = mesh_.device_->gl;
    if (!mesh_.hasTangents())
        gl.VertexAttrib4f(kTangent, tangent_[0], tangent_[1], tangent_[2], tangent_[3]);
    if (mesh_.vertexArray_) return;
    // glVertexAttribPointer takes the buffer that is bound, so each pointer needs its buffer first.
    // The host's own binding of GL_ARRAY_BUFFER is put back by StateGuard, which ends later.
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

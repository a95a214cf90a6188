// Mesh.h - the buffers of a mesh, and drawing them.
#pragma once
#include "Objects.h"

#include <fbrdf/plan/LightSelection.h>

#include <array>
#include <vector>

namespace fbrdf::gl {

/// Locations that every program binds its attributes to; extra array k is at kExtra + k.
enum Attribute : GLuint {
    kPosition,
    kNormal,
    kTangent,
    kTextureCoordinate,
    kExtra,
    kAttributeCount = kExtra + kExtraArrays
};

class GpuMesh {
public:
    GpuMesh(DevicePtr device, const MeshData& mesh);

    const Device* device() const { return device_.get(); }
    bool hasTangents() const { return hasTangents_; }
    bool has(GLuint attribute) const { return arrays_[attribute].components > 0; }
    const Sphere& bounds() const { return bounds_; }  ///< object space
    /// Draws between bind and unbind of a MeshBinding.
    /// instances: 0 draws without instancing.
    void draw(int instances) const;

private:
    friend class MeshBinding;
    struct Array {
        GLint components = 0;  ///< 0: the mesh has no such array
        size_t offset = 0;     ///< bytes
    };
    void upload(const MeshData& mesh);
    void uploadVertices(const MeshData& mesh);
    void setAttributes() const;

    DevicePtr device_;
    Object vertices_, indices_, vertexArray_;
    GLsizei indexCount_ = 0;
    size_t vertexCount_ = 0;
    std::array<Array, kAttributeCount> arrays_{};
    bool hasTangents_ = false;
    Sphere bounds_;
};

/// Makes a mesh the vertex input for its lifetime. Vertex array and array buffer are the caller's
/// to put back; without vertex arrays this puts back the attributes and the element buffer, as
/// StateMode says.
class MeshBinding {
public:
    explicit MeshBinding(const GpuMesh& mesh);
    ~MeshBinding();
    MeshBinding(const MeshBinding&) = delete;
    MeshBinding& operator=(const MeshBinding&) = delete;

private:
    struct SavedAttribute {
        GLint enabled = 0, size = 4, type = GL_FLOAT, normalized = 0, stride = 0, buffer = 0;
        void* pointer = nullptr;
    };
    void save();

    const GpuMesh& mesh_;
    SavedAttribute saved_[kAttributeCount];
    GLint elementBuffer_ = 0;
};

}  // namespace fbrdf::gl

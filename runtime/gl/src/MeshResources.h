// MeshResources.h - a mesh that can be drawn, and its binding as the vertex input.
#pragma once
#include "MeshArrays.h"

namespace fbrdf::gl {

class MeshResources {
public:
    /// Throws Error(input) or Error(gl), as Renderer::createMesh.
    MeshResources(DevicePtr device, const MeshData& mesh);
    MeshResources(DevicePtr device, const MeshBuffers& mesh);

    const Device* device() const { return device_.get(); }
    bool has(GLuint attribute) const { return arrays_.attributes[attribute].components > 0; }
    bool hasTangents() const { return has(kTangent); }
    const Sphere& bounds() const { return arrays_.bounds; }  ///< object space
    /// Draws between bind and unbind of a MeshBinding. instances: 0 draws without instancing.
    void draw(int instances) const;

private:
    friend class MeshBinding;
    void bindVertexArray();
    void setAttributes() const;

    DevicePtr device_;
    MeshStorage storage_;
    Object vertexArray_;
    MeshArrays arrays_;
};

/// Makes a mesh the vertex input for its lifetime. Vertex array and array buffer are the caller's
/// to put back. The current value of a tangent that the mesh does not have is put back here, and
/// without vertex arrays also the attributes and the element buffer, as StateMode says.
class MeshBinding {
public:
    explicit MeshBinding(const MeshResources& mesh);
    ~MeshBinding();
    MeshBinding(const MeshBinding&) = delete;
    MeshBinding& operator=(const MeshBinding&) = delete;

private:
    struct SavedAttribute {
        GLint enabled = 0, size = 4, type = GL_FLOAT, normalized = 0, stride = 0, buffer = 0;
        void* pointer = nullptr;
    };
    void save();
    void setMissingTangent();

    const MeshResources& mesh_;
    SavedAttribute saved_[kAttributeCount];
    GLint elementBuffer_ = 0;
    GLfloat tangent_[4] = {0.0f, 0.0f, 0.0f, 1.0f};  ///< the initial value of an attribute
};

}  // namespace fbrdf::gl

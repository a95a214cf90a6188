#include "bench/PeerMesh.h"

namespace fbrdf::bench {

PeerMesh::PeerMesh(const GladGLContext& gl, const gl::MeshData& mesh)
    : gl_(gl), count_(static_cast<GLsizei>(mesh.indices.size()))
{
    gl_.GenVertexArrays(1, &array_);
    gl_.BindVertexArray(array_);
    gl_.GenBuffers(4, buffers_);
    const auto upload = [this](GLenum target, GLuint buffer, const auto& data) {
        gl_.BindBuffer(target, buffer);
        gl_.BufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof data[0]), data.data(),
                       GL_STATIC_DRAW);
    };
    const std::vector<Vec3f>* const attributes[] = {&mesh.positions, &mesh.normals, &mesh.tangents};
    for (GLuint i = 0; i < 3; ++i) {
        upload(GL_ARRAY_BUFFER, buffers_[i], *attributes[i]);
        gl_.VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        gl_.EnableVertexAttribArray(i);
    }
    upload(GL_ELEMENT_ARRAY_BUFFER, buffers_[3], mesh.indices);
    gl_.BindVertexArray(0);
}

PeerMesh::~PeerMesh()
{
    gl_.DeleteBuffers(4, buffers_);
    gl_.DeleteVertexArrays(1, &array_);
}

}  // namespace fbrdf::bench

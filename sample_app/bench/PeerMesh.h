// PeerMesh.h - the mesh of a stage in buffers of its own, for programs that are not the runtime's.
#pragma once
#include "bench/Stage.h"
#include "viewer/GlFunctions.h"

namespace fbrdf::bench {

class PeerMesh {
public:
    PeerMesh(const GladGLContext& gl, const gl::MeshData& mesh);
    ~PeerMesh();
    PeerMesh(const PeerMesh&) = delete;
    PeerMesh& operator=(const PeerMesh&) = delete;

    void bind() const { gl_.BindVertexArray(array_); }
    void draw() const { gl_.DrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr); }

private:
    const GladGLContext& gl_;
    GLsizei count_ = 0;
    GLuint array_ = 0, buffers_[4] = {};
};

}  // namespace fbrdf::bench

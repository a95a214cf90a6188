// GgxEnvironment.h - the peer of materials under an environment: GGX by the split sum, with three
// look-ups, in the environment that the runtime has prefiltered.
#pragma once
#include "bench/PeerMesh.h"

namespace fbrdf::bench {

class GgxEnvironment {
public:
    /// Throws std::runtime_error with the compiler's log.
    GgxEnvironment(const GladGLContext& gl, const Stage& stage,
                   std::shared_ptr<gl::GpuEnvironment> environment);
    ~GgxEnvironment();
    GgxEnvironment(const GgxEnvironment&) = delete;
    GgxEnvironment& operator=(const GgxEnvironment&) = delete;

    /// Draws what gl::Renderer::draw would: depth test LESS against what is there.
    void draw(const gl::Target& target) const;

    /// What GGX of kAlpha with f0 = 1 has more than with f0 = 0, and the latter: the shader's table
    /// at one NoV.
    static Vec2<double> albedo(double cosine);

private:
    GLint location(const char* name) const { return gl_.GetUniformLocation(program_, name); }
    void uploadAlbedo();
    void setUniforms(const gl::View& view) const;

    const GladGLContext& gl_;
    std::shared_ptr<gl::GpuEnvironment> environment_;
    PeerMesh mesh_;
    GLuint program_ = 0, albedo_ = 0;
};

}  // namespace fbrdf::bench

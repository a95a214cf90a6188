// ShaderPeer.h - another way to draw a material: a GLSL function f(wo, wi), its data and its CPU
// twin. It is drawn by the same vertex shader and the same light loop as the runtime's.
#pragma once
#include "bench/PeerMesh.h"

#include <fbrdf/shaders/TextureImage.h>

#include <glm/vec4.hpp>

namespace fbrdf::bench {

/// A texture of a peer.
struct PeerMap {
    std::string sampler;  ///< its name in the shader
    TextureImage image;
    bool repeats = false;  ///< repeats along x; otherwise it is clamped
};

struct ShaderPeer {
    std::string name, description;
    std::string shader;                 ///< text that defines peerView and peerBrdf
    std::vector<glm::vec4> parameters;  ///< peerParameters
    std::vector<PeerMap> maps;
    /// f(wo, wi) on the CPU, in double. Directions are unit, local and above the horizon.
    std::function<Vec3d(const Vec3d& wo, const Vec3d& wi)> evaluate;
    bool passPerLight =
        false;  ///< one additive pass for each light, after a black one that writes depth
};

/// The fragment shader of a peer with an array of so many lights.
std::string peerFragmentSource(const ShaderPeer& peer, int slots);

/// A peer and a stage in the context that is current when it is made.
class PeerDrawing {
public:
    /// The limit of lights in one pass, even where the context allows more.
    static constexpr int kMostLights = 1024;

    /// Throws Error(gl) with the compiler's log.
    PeerDrawing(const GladGLContext& gl, const ShaderPeer& peer, const Stage& stage, int lights);
    ~PeerDrawing();
    PeerDrawing(const PeerDrawing&) = delete;
    PeerDrawing& operator=(const PeerDrawing&) = delete;

    /// Adds to the target what gl::Renderer::draw would: depth test LESS against what is there.
    void draw(const gl::Target& target, const std::vector<Light>& lights) const;

private:
    void uploadMap(const PeerMap& map);
    void setUniforms() const;
    void drawBlack() const;
    GLint location(const char* name) const { return gl_.GetUniformLocation(program_, name); }

    const GladGLContext& gl_;
    const ShaderPeer& peer_;
    gl::View view_;
    PeerMesh mesh_;
    int slots_ = 1;  ///< lights in one pass
    GLuint program_ = 0;
    std::vector<GLuint> textures_;
};

}  // namespace fbrdf::bench

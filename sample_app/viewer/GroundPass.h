// GroundPass.h - the environment on the ground, and the ground's transparency: what the runtime,
// which lights the plane with everything else, does not draw of it.
#pragma once
#include "GlFunctions.h"

#include <fbrdf/scene/Ground.h>

namespace fbrdf::viewer {

/// Owns GL objects of the context that is current when it is made; all calls need that context.
class GroundPass {
public:
    explicit GroundPass(gl::LoadFunction load);
    ~GroundPass();
    GroundPass(const GroundPass&) = delete;
    GroundPass& operator=(const GroundPass&) = delete;

    /// Takes Ground::visibility().
    void setVisibility(const scene::SkyVisibility& visibility);
    /// Expects a target that contains nothing but the lit plane, drawn from `view`; irradiance: of
    /// the environment on an open ground.
    void draw(const gl::Target& target, const gl::View& view, const scene::Ground& ground,
              const Vec3d& irradiance);

private:
    GladGLContext gl_;
    GLuint program_ = 0, vertexArray_ = 0, visibility_ = 0;
};

}  // namespace fbrdf::viewer

// ShadowMaps.h - what the objects hide of a few lights: a depth map for each, which the runtime's
// shadow hook reads.
#pragma once
#include "GlFunctions.h"

#include <fbrdf/scene/KeyLights.h>
#include <fbrdf/scene/Raster.h>

namespace fbrdf::viewer {

/// Owns GL objects of the context that is current when it is made; all calls need that context.
/// What hooks() returns points to it.
class ShadowMaps {
public:
    explicit ShadowMaps(gl::LoadFunction load);
    ~ShadowMaps();
    ShadowMaps(const ShadowMaps&) = delete;
    ShadowMaps& operator=(const ShadowMaps&) = delete;

    /// Takes the mesh that all objects are of.
    void setMesh(const scene::Mesh& mesh);
    /// Draws the maps of lights, at most scene::kMostShadowed of them, unless they show these
    /// objects from there already; and makes programs see from the eye of `view`.
    void draw(const std::vector<scene::Instance>& objects,
              const std::vector<scene::ShadowedLight>& lights, const gl::View& view);
    gl::Hooks hooks() const;

private:
    struct Map {
        int light = -1;
        glm::mat4 clipFromWorld{1.0f};
        bool operator==(const Map& o) const
        {
            return light == o.light && clipFromWorld == o.clipFromWorld;
        }
    };
    void drawMaps(const std::vector<scene::Instance>& objects);
    void setUniforms(uint32_t program) const;

    GladGLContext gl_;
    GLuint program_ = 0, vertexArray_ = 0, positions_ = 0, indices_ = 0;
    GLuint framebuffer_ = 0, depths_ = 0;
    GLsizei indexCount_ = 0;
    std::vector<Map> maps_;
    std::vector<glm::mat4> drawn_;  ///< the objects in the maps; empty: none yet
    glm::mat4 worldFromEye_{1.0f};
};

}  // namespace fbrdf::viewer

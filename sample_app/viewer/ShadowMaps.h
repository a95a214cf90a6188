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

    /// Takes the mesh that all objects are of, and what is enough of it for coarse maps.
    void setMesh(const scene::Mesh& mesh, const scene::Mesh& coarse);
    /// Draws the maps of lights, at most scene::kMostShadowed of them, unless they show these
    /// objects from there already; and makes programs see from the eye of `view`. step: the picture
    /// has one pixel in step x step, and the maps may have as few.
    void draw(const std::vector<scene::Instance>& objects,
              const std::vector<scene::ShadowedLight>& lights, const gl::View& view, int step);
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
    /// Triangles in buffers.
    struct Triangles {
        GLuint vertexArray = 0, positions = 0, indices = 0;
        GLsizei indexCount = 0;
    };
    void upload(const scene::Mesh& mesh, Triangles& triangles) const;
    void setLevel(int level);
    void drawMaps(const std::vector<scene::Instance>& objects);
    void setUniforms(uint32_t program) const;

    GladGLContext gl_;
    GLuint program_ = 0, framebuffer_ = 0, depths_ = 0;
    Triangles whole_, coarse_;
    std::vector<Map> maps_;
    int level_ = 0;                 ///< of the texture, which has the maps in one of its sizes
    std::vector<glm::mat4> drawn_;  ///< the objects in the maps; empty: none yet
    glm::mat4 worldFromEye_{1.0f};
};

}  // namespace fbrdf::viewer

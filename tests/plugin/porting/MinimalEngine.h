// MinimalEngine.h - the least that an engine's plugin does: a material drawn in a context of OpenGL
// 3.3 by fbrdf::plan and fbrdf::shaders alone, without the runtime's renderer. docs/porting.md is
// cut from MinimalEngine.cpp.
#pragma once
#include <glad/gl.h>

#include <fbrdf/brdf/Material.h>
#include <fbrdf/plan/Light.h>
#include <fbrdf/plan/Plan.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace fbrdf::porting {

/// Triangles of one object in object space; the arrays are equally long.
struct Mesh {
    std::vector<Vec3f> positions, normals, tangents;
    std::vector<uint32_t> indices;
};

/// What an engine knows of a draw. The target has a depth buffer and RGBA32F colours.
struct Frame {
    GLuint framebuffer = 0;
    int width = 0, height = 0;  ///< pixels
    glm::mat4 modelView{1.0f}, projection{1.0f};
    std::vector<Light> lights;  ///< eye space, valid
    Technique technique = Technique::single;
    Transfer transfer = Transfer::linear;
    float exposure = 1.0f;
};

/// One material and one mesh. Every call needs the context current, the destructor included.
class MinimalEngine {
public:
    MinimalEngine(const GladGLContext& gl, const Material& material, const Mesh& mesh);
    ~MinimalEngine();
    MinimalEngine(const MinimalEngine&) = delete;
    MinimalEngine& operator=(const MinimalEngine&) = delete;

    /// Draws the object and returns the plan. Where the plan is not feasible nothing is drawn: an
    /// engine draws its own material instead and logs Plan::reason.
    Plan draw(const Frame& frame);

private:
    /// A table on the GPU: a texture, or knots for a uniform array.
    struct Map {
        GLuint texture = 0;
        GLenum target = GL_TEXTURE_2D;
        TableEncoding encoding;
        Vec3f lower{0.0f}, extent{1.0f};
        std::vector<Vec3f> knots;
    };
    Map mapOf(const Table& table, bool uniform) const;
    void uploadMesh(const Mesh& mesh);
    void makeSurfaces(int width, int height);
    void deleteSurfaces();
    GLuint programOf(const ProgramSpec& spec);
    GLint location(GLuint program, const std::string& name) const;
    void bindMaps(GLuint program) const;
    void setUniforms(GLuint program, const Pass& pass, const Frame& frame) const;
    void setState(const Pass& pass) const;

    const GladGLContext& gl_;
    Material material_;
    Capabilities capabilities_;
    std::vector<Map> maps_;
    std::vector<TableEncoding> encodings_;
    std::map<std::string, GLuint> programs_;  ///< by the text of the fragment shader
    GLuint vertexArray_ = 0;
    std::array<GLuint, 4> buffers_{};  ///< positions, normals, tangents, indices
    GLsizei indexCount_ = 0;
    int width_ = 0, height_ = 0;  ///< of the surfaces
    std::array<GLuint, 3> surfaces_{}, framebuffers_{};
    GLuint depth_ = 0;
};

}  // namespace fbrdf::porting

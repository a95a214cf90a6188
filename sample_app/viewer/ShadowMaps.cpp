#include "ShadowMaps.h"

#include "GlProgram.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/scene/Layout.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace fbrdf::viewer {
namespace {

constexpr int kMapSize = 1024;  ///< texels on a side: about two a pixel of a large object
// Each level of the texture has half as many on a side. Without a GPU four maps of 1024 texels take
// half of the time of a coarse picture.
constexpr int kLevels = 3;
// The last of the 16 units that OpenGL 3.3 promises; the runtime counts from 0.
constexpr int kUnit = 15;
// Depths are moved away from the light by these (glPolygonOffset), so that texels do not shade the
// slanted surface that they show: the filter reaches one texel.
constexpr float kSlopeOffset = 2.0f, kConstantOffset = 8.0f;

/// What encloses the ball of all objects as a light outside of it sees them.
glm::mat4 clipFromWorldOf(const Light& light, const scene::Bounds& ball)
{
    const Vec3d centre(ball.centre), place(light.position);
    const double radius = 1.01 * static_cast<double>(ball.radius);
    const bool isFar = light.type == Light::Type::directional;
    const Vec3d away = isFar ? glm::normalize(place) : glm::normalize(place - centre);
    const double distance = isFar ? 2.0 * radius : glm::distance(place, centre);
    const Vec3d up = std::abs(away.y) < 0.9 ? Vec3d(0.0, 1.0, 0.0) : Vec3d(0.0, 0.0, 1.0);
    const glm::dmat4 view = glm::lookAt(centre + distance * away, centre, up);
    const double near = distance - radius, far = distance + radius;
    const glm::dmat4 projection =
        isFar ? glm::ortho(-radius, radius, -radius, radius, near, far)
              : glm::perspective(2.0 * std::asin(radius / distance), 1.0, near, far);
    return glm::mat4(projection * view);
}

int levelFor(int step)
{
    int level = 0;
    while (level + 1 < kLevels && step >> (level + 1) > 0) ++level;
    return level;
}

/// From clip coordinates to those of a texture.
glm::mat4 textureFromClip()
{
    return glm::scale(glm::translate(glm::mat4(1.0f), Vec3f(0.5f)), Vec3f(0.5f));
}

}  // namespace

ShadowMaps::ShadowMaps(gl::LoadFunction load)
    : gl_(loadGlFunctions(load)), program_(linkedProgram(gl_, "shadow.vert", "shadow.frag"))
{
    for (Triangles* triangles : {&whole_, &coarse_}) {
        gl_.GenVertexArrays(1, &triangles->vertexArray);
        gl_.GenBuffers(1, &triangles->positions);
        gl_.GenBuffers(1, &triangles->indices);
    }
    gl_.GenFramebuffers(1, &framebuffer_);
    gl_.GenTextures(1, &depths_);
    gl_.ActiveTexture(GL_TEXTURE0 + kUnit);
    gl_.BindTexture(GL_TEXTURE_2D_ARRAY, depths_);
    for (int level = 0; level < kLevels; ++level)
        gl_.TexImage3D(GL_TEXTURE_2D_ARRAY, level, GL_DEPTH_COMPONENT24, kMapSize >> level,
                       kMapSize >> level, scene::kMostShadowed, 0, GL_DEPTH_COMPONENT,
                       GL_UNSIGNED_INT, nullptr);
    for (const auto& [name, value] :
         {std::pair(GL_TEXTURE_MIN_FILTER, GL_LINEAR), std::pair(GL_TEXTURE_MAG_FILTER, GL_LINEAR),
          std::pair(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE),
          std::pair(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE),
          std::pair(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE),
          std::pair(GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL)})
        gl_.TexParameteri(GL_TEXTURE_2D_ARRAY, static_cast<GLenum>(name), value);
    setLevel(0);
}

ShadowMaps::~ShadowMaps()
{
    gl_.DeleteTextures(1, &depths_);
    gl_.DeleteFramebuffers(1, &framebuffer_);
    for (const Triangles* triangles : {&whole_, &coarse_}) {
        gl_.DeleteBuffers(1, &triangles->indices);
        gl_.DeleteBuffers(1, &triangles->positions);
        gl_.DeleteVertexArrays(1, &triangles->vertexArray);
    }
    gl_.DeleteProgram(program_);
}

void ShadowMaps::setMesh(const scene::Mesh& mesh, const scene::Mesh& coarse)
{
    upload(mesh, whole_);
    upload(coarse, coarse_);
    drawn_.clear();
}

void ShadowMaps::upload(const scene::Mesh& mesh, Triangles& triangles) const
{
    const auto bytes = [](const auto& values) {
        return static_cast<GLsizeiptr>(values.size() * sizeof values[0]);
    };
    gl_.BindVertexArray(triangles.vertexArray);
    gl_.BindBuffer(GL_ARRAY_BUFFER, triangles.positions);
    gl_.BufferData(GL_ARRAY_BUFFER, bytes(mesh.positions), mesh.positions.data(), GL_STATIC_DRAW);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles.indices);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, bytes(mesh.indices), mesh.indices.data(),
                   GL_STATIC_DRAW);
    gl_.EnableVertexAttribArray(0);
    gl_.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3f), nullptr);
    gl_.BindVertexArray(0);
    gl_.BindBuffer(GL_ARRAY_BUFFER, 0);
    triangles.indexCount = static_cast<GLsizei>(mesh.indices.size());
}

/// Lets samplers see that level alone.
void ShadowMaps::setLevel(int level)
{
    level_ = level;
    gl_.ActiveTexture(GL_TEXTURE0 + kUnit);
    gl_.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, level);
    gl_.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, level);
    gl_.ActiveTexture(GL_TEXTURE0);
}

void ShadowMaps::draw(const std::vector<scene::Instance>& objects,
                      const std::vector<scene::ShadowedLight>& lights, const gl::View& view,
                      int step)
{
    FBRDF_ASSERT(lights.size(), <=, static_cast<size_t>(scene::kMostShadowed));
    worldFromEye_ = glm::inverse(view.view);
    std::vector<Map> maps;
    const scene::Bounds ball = scene::boundsOf(objects);
    for (const scene::ShadowedLight& light : lights)
        maps.push_back({light.place, clipFromWorldOf(light.from, ball)});
    std::vector<glm::mat4> models;
    for (const scene::Instance& object : objects) models.push_back(object.model);
    const int level = levelFor(step);
    if (maps == maps_ && models == drawn_ && level == level_) return;
    maps_ = maps;
    drawn_ = models;
    setLevel(level);
    drawMaps(objects);
}

void ShadowMaps::drawMaps(const std::vector<scene::Instance>& objects)
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.DrawBuffer(GL_NONE);
    gl_.ReadBuffer(GL_NONE);
    gl_.Viewport(0, 0, kMapSize >> level_, kMapSize >> level_);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.Enable(GL_POLYGON_OFFSET_FILL);
    gl_.PolygonOffset(kSlopeOffset, kConstantOffset);
    gl_.UseProgram(program_);
    const Triangles& triangles = level_ > 0 ? coarse_ : whole_;
    gl_.BindVertexArray(triangles.vertexArray);
    const GLint clipFromObject = gl_.GetUniformLocation(program_, "clipFromObject");
    for (size_t i = 0; i < maps_.size(); ++i) {
        gl_.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depths_, level_,
                                    static_cast<GLint>(i));
        gl_.Clear(GL_DEPTH_BUFFER_BIT);
        for (const scene::Instance& object : objects) {
            const glm::mat4 matrix = maps_[i].clipFromWorld * object.model;
            gl_.UniformMatrix4fv(clipFromObject, 1, GL_FALSE, &matrix[0][0]);
            gl_.DrawElements(GL_TRIANGLES, triangles.indexCount, GL_UNSIGNED_INT, nullptr);
        }
    }
    gl_.BindVertexArray(0);
    gl_.UseProgram(0);
    gl_.Disable(GL_POLYGON_OFFSET_FILL);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

gl::Hooks ShadowMaps::hooks() const
{
    gl::Hooks hooks;
    hooks.shadow = viewerShader("shadow_hook.glsl");
    hooks.shadowUniforms = 4 * scene::kMostShadowed + 1;
    hooks.setUniforms = [this](uint32_t program) { setUniforms(program); };
    return hooks;
}

void ShadowMaps::setUniforms(uint32_t program) const
{
    glm::vec4 lights(-1.0f);
    glm::mat4 matrices[scene::kMostShadowed];
    for (size_t i = 0; i < maps_.size(); ++i) {
        lights[static_cast<int>(i)] = static_cast<float>(maps_[i].light);
        matrices[i] = textureFromClip() * maps_[i].clipFromWorld * worldFromEye_;
    }
    gl_.Uniform1i(gl_.GetUniformLocation(program, "shadowMaps"), kUnit);
    gl_.Uniform4fv(gl_.GetUniformLocation(program, "shadowLights"), 1, &lights[0]);
    gl_.UniformMatrix4fv(gl_.GetUniformLocation(program, "shadowFromEye"), scene::kMostShadowed,
                         GL_FALSE, &matrices[0][0][0]);
}

}  // namespace fbrdf::viewer

#include "bench/ShaderPeer.h"

#include "EmbeddedShaders.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/plan/LightVectors.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace fbrdf {

std::string_view peerShader(std::string_view name);

namespace bench {
namespace {

constexpr int kGlsl = 330;

GLuint compiled(const GladGLContext& gl, GLenum stage, const std::string& text)
{
    const GLuint shader = gl.CreateShader(stage);
    const GLchar* source = text.c_str();
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    GLint ok = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok) return shader;
    char log[4096] = {};
    gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
    throw Error(ErrorKind::gl, "peer", std::string("found a shader that does not compile: ") + log);
}

GLuint linked(const GladGLContext& gl, const std::string& fragment)
{
    const GLuint program = gl.CreateProgram();
    for (const GLuint shader : {compiled(gl, GL_VERTEX_SHADER, vertexSource(kGlsl)),
                                compiled(gl, GL_FRAGMENT_SHADER, fragment)}) {
        gl.AttachShader(program, shader);
        gl.DeleteShader(shader);
    }
    gl.BindAttribLocation(program, 0, "fbrdfVertex");
    gl.BindAttribLocation(program, 1, "fbrdfVertexNormal");
    gl.BindAttribLocation(program, 2, "fbrdfVertexTangent");
    gl.LinkProgram(program);
    GLint ok = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &ok);
    if (ok) return program;
    char log[4096] = {};
    gl.GetProgramInfoLog(program, sizeof log, nullptr, log);
    throw Error(ErrorKind::gl, "peer", std::string("found a program that does not link: ") + log);
}

int slotsFor(const GladGLContext& gl, const ShaderPeer& peer, int lights)
{
    if (peer.passPerLight) return 1;
    GLint components = 0;
    gl.GetIntegerv(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS, &components);
    const int reserved = static_cast<int>(peer.parameters.size()) + 24;
    return std::clamp(std::min(lights, (components / 4 - reserved) / kVectorsPerLight), 1,
                      PeerDrawing::kMostLights);
}

std::vector<LightVectors> vectorsOf(const std::vector<Light>& lights, const gl::View& view)
{
    std::vector<LightVectors> vectors;
    for (const Light& light : lights) vectors.push_back(lightVectors(light, glm::dmat4(view.view)));
    return vectors;
}

}  // namespace

std::string peerFragmentSource(const ShaderPeer& peer, int slots)
{
    std::string text = "#version " + std::to_string(kGlsl) + "\n#define PEER_LIGHTS " +
                       std::to_string(slots) + "\n";
    for (const char* file : {"version.glsl", "surface.glsl", "frame.glsl", "angles.glsl",
                             "projection.glsl", "lights.glsl"})
        text += embeddedShader(file);
    return text + peer.shader + std::string(peerShader("peer_main.glsl"));
}

PeerDrawing::PeerDrawing(const GladGLContext& gl, const ShaderPeer& peer, const Stage& stage,
                         int lights)
    : gl_(gl),
      peer_(peer),
      view_(stage.view),
      mesh_(gl, stage.mesh),
      slots_(slotsFor(gl, peer, lights)),
      program_(linked(gl_, peerFragmentSource(peer, slots_)))
{
    for (const PeerMap& map : peer.maps) uploadMap(map);
    setUniforms();
}

PeerDrawing::~PeerDrawing()
{
    gl_.DeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
    gl_.DeleteProgram(program_);
}

void PeerDrawing::uploadMap(const PeerMap& map)
{
    const bool volume = map.image.size[2] > 1, half = map.image.type == TexelType::half;
    const GLenum target = volume ? GL_TEXTURE_3D : GL_TEXTURE_2D;
    const GLint format = half ? GL_RGB16F : GL_RGB16;
    const GLenum type = half ? GL_HALF_FLOAT : GL_UNSIGNED_SHORT;
    GLuint texture = 0;
    gl_.GenTextures(1, &texture);
    gl_.BindTexture(target, texture);
    gl_.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_.TexParameteri(target, GL_TEXTURE_WRAP_S, map.repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(target, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const auto [width, height, depth] = map.image.size;
    if (volume)
        gl_.TexImage3D(target, 0, format, width, height, depth, 0, GL_RGB, type,
                       map.image.words.data());
    else
        gl_.TexImage2D(target, 0, format, width, height, 0, GL_RGB, type, map.image.words.data());
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_.BindTexture(target, 0);
    textures_.push_back(texture);
}

void PeerDrawing::setUniforms() const
{
    gl_.UseProgram(program_);
    const glm::vec4 eye(eyeFromProjection(glm::dmat4(view_.projection)));
    gl_.UniformMatrix4fv(location("fbrdfModelView"), 1, GL_FALSE, glm::value_ptr(view_.view));
    gl_.UniformMatrix4fv(location("fbrdfProjection"), 1, GL_FALSE,
                         glm::value_ptr(view_.projection));
    gl_.Uniform4fv(location("fbrdfEye"), 1, glm::value_ptr(eye));
    if (!peer_.parameters.empty())
        gl_.Uniform4fv(location("peerParameters"), static_cast<GLsizei>(peer_.parameters.size()),
                       glm::value_ptr(peer_.parameters[0]));
    for (size_t i = 0; i < peer_.maps.size(); ++i)
        gl_.Uniform1i(location(peer_.maps[i].sampler.c_str()), static_cast<GLint>(i));
    gl_.UseProgram(0);
}

/// The base pass of an effect with one pass for each light: black, writes depth.
void PeerDrawing::drawBlack() const
{
    gl_.Uniform1i(location("fbrdfLightCount"), 0);
    mesh_.draw();
    gl_.DepthFunc(GL_EQUAL);
    gl_.DepthMask(GL_FALSE);
    gl_.Enable(GL_BLEND);
}

void PeerDrawing::draw(const gl::Target& target, const std::vector<Light>& lights) const
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl_.Viewport(0, 0, target.width, target.height);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);  // alpha is coverage
    gl_.UseProgram(program_);
    mesh_.bind();
    for (size_t i = 0; i < textures_.size(); ++i) {
        gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        gl_.BindTexture(peer_.maps[i].image.size[2] > 1 ? GL_TEXTURE_3D : GL_TEXTURE_2D,
                        textures_[i]);
    }
    const std::vector<LightVectors> vectors = vectorsOf(lights, view_);
    if (peer_.passPerLight) drawBlack();
    const int count = static_cast<int>(lights.size());
    for (int first = 0; first < count; first += slots_) {
        const int inPass = std::min(slots_, count - first);
        gl_.Uniform4fv(location("fbrdfLights"), kVectorsPerLight * inPass,
                       glm::value_ptr(vectors[static_cast<size_t>(first)][0]));
        gl_.Uniform1i(location("fbrdfLightCount"), inPass);
        mesh_.draw();
        gl_.DepthFunc(GL_EQUAL);
        gl_.Enable(GL_BLEND);
    }
    gl_.Disable(GL_BLEND);
    gl_.DepthMask(GL_TRUE);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.BindVertexArray(0);
    gl_.UseProgram(0);
}

}  // namespace bench
}  // namespace fbrdf

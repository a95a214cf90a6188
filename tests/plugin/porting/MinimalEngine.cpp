#include "MinimalEngine.h"

#include <fbrdf/plan/LightVectors.h>
#include <fbrdf/shaders/TextureImage.h>

#include <glm/gtc/type_ptr.hpp>

#include <stdexcept>

namespace fbrdf::porting {
namespace {

// Any numbers will do; the programs are linked with them.
constexpr GLuint kPosition = 0, kNormal = 1, kTangent = 2;

// [capabilities]
Capabilities capabilitiesOf(const GladGLContext& gl)
{
    Capabilities c;
    c.glsl = 330;
    gl.GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &c.maxTextureUnits);
    GLint components = 0;
    gl.GetIntegerv(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS, &components);
    c.maxUniformVectors = components / 4;
    c.framebufferObjects = c.floatTextures = c.floatTargets = true;  // OpenGL 3.0 has them
    return c;
}
// [end]

GLuint compiled(const GladGLContext& gl, GLenum stage, const std::string& source)
{
    const GLuint shader = gl.CreateShader(stage);
    const GLchar* text = source.c_str();
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    GLint ok = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) throw std::runtime_error("found a shader that does not compile:\n" + source);
    return shader;
}

struct Format {
    GLint internal;
    GLenum type;
};

// [format]
Format formatOf(TexelType type)
{
    switch (type) {
        case TexelType::unorm16: return {GL_RGB16, GL_UNSIGNED_SHORT};
        case TexelType::half: return {GL_RGB16F, GL_HALF_FLOAT};
        case TexelType::float32: return {GL_RGB32F, GL_FLOAT};
    }
    return {};
}
// [end]

}  // namespace

MinimalEngine::MinimalEngine(const GladGLContext& gl, const Material& material, const Mesh& mesh)
    : gl_(gl), material_(material), capabilities_(capabilitiesOf(gl))
{
    // [tables]
    for (size_t k = 0; k < material_.tables.size(); ++k) {
        maps_.push_back(mapOf(material_.tables[k], material_.form.tables[k].uniform));
        encodings_.push_back(maps_.back().encoding);
    }
    // [end]
    uploadMesh(mesh);
}

MinimalEngine::~MinimalEngine()
{
    for (const Map& map : maps_) gl_.DeleteTextures(1, &map.texture);
    for (const auto& [text, program] : programs_) gl_.DeleteProgram(program);
    gl_.DeleteVertexArrays(1, &vertexArray_);
    gl_.DeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    deleteSurfaces();
}

// [map]
MinimalEngine::Map MinimalEngine::mapOf(const Table& table, bool uniform) const
{
    Map map;
    if (uniform) {
        map.knots = uniformKnots(table);
        map.encoding.logarithmic = isLog(table.storage);
        return map;
    }
    const TextureImage image = textureImage(table, capabilities_);
    map.encoding = image.encoding;
    map.lower = image.lower;
    map.extent = image.extent;
    map.target = dimensionCount(table.domain) == 3 ? GL_TEXTURE_3D : GL_TEXTURE_2D;
    gl_.GenTextures(1, &map.texture);
    gl_.BindTexture(map.target, map.texture);
    gl_.TexParameteri(map.target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_.TexParameteri(map.target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    const GLenum axes[] = {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
    for (const GLenum axis : axes) gl_.TexParameteri(map.target, axis, GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(map.target, GL_TEXTURE_MAX_LEVEL, 0);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);  // rows of RGB are packed
    const Format format = formatOf(image.type);
    const auto [width, height, depth] = image.size;
    const void* texels = image.type == TexelType::float32
                             ? static_cast<const void*>(image.floats.data())
                             : static_cast<const void*>(image.words.data());
    if (map.target == GL_TEXTURE_3D)
        gl_.TexImage3D(map.target, 0, format.internal, width, height, depth, 0, GL_RGB, format.type,
                       texels);
    else
        gl_.TexImage2D(map.target, 0, format.internal, width, height, 0, GL_RGB, format.type,
                       texels);
    return map;
}
// [end]

void MinimalEngine::uploadMesh(const Mesh& mesh)
{
    gl_.GenVertexArrays(1, &vertexArray_);
    gl_.GenBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    gl_.BindVertexArray(vertexArray_);
    const std::vector<Vec3f>* arrays[] = {&mesh.positions, &mesh.normals, &mesh.tangents};
    for (const GLuint attribute : {kPosition, kNormal, kTangent}) {
        const std::vector<Vec3f>& array = *arrays[attribute];
        gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[attribute]);
        gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(array.size() * sizeof(Vec3f)),
                       array.data(), GL_STATIC_DRAW);
        gl_.VertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        gl_.EnableVertexAttribArray(attribute);
    }
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[3]);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                   static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(uint32_t)),
                   mesh.indices.data(), GL_STATIC_DRAW);
    indexCount_ = static_cast<GLsizei>(mesh.indices.size());
}

// [program]
GLuint MinimalEngine::programOf(const ProgramSpec& spec)
{
    const std::string fragment =
        fragmentSource(material_.form, encodings_, spec, capabilities_.glsl);
    GLuint& program = programs_[fragment];
    if (program) return program;
    program = gl_.CreateProgram();
    const GLuint shaders[] = {compiled(gl_, GL_VERTEX_SHADER, vertexSource(capabilities_.glsl)),
                              compiled(gl_, GL_FRAGMENT_SHADER, fragment)};
    for (const GLuint shader : shaders) gl_.AttachShader(program, shader);
    gl_.BindAttribLocation(program, kPosition, "fbrdfVertex");
    gl_.BindAttribLocation(program, kNormal, "fbrdfVertexNormal");
    gl_.BindAttribLocation(program, kTangent, "fbrdfVertexTangent");
    gl_.LinkProgram(program);
    for (const GLuint shader : shaders) gl_.DeleteShader(shader);
    return program;
}
// [end]

// [surfaces]
void MinimalEngine::makeSurfaces(int width, int height)
{
    if (width == width_ && height == height_) return;
    deleteSurfaces();
    width_ = width;
    height_ = height;
    gl_.GenRenderbuffers(1, &depth_);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, depth_);
    gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    gl_.GenTextures(3, surfaces_.data());
    gl_.GenFramebuffers(3, framebuffers_.data());
    for (size_t i = 0; i < surfaces_.size(); ++i) {
        gl_.BindTexture(GL_TEXTURE_2D, surfaces_[i]);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[i]);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, surfaces_[i],
                                 0);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
    }
}
// [end]

void MinimalEngine::deleteSurfaces()
{
    gl_.DeleteFramebuffers(3, framebuffers_.data());
    gl_.DeleteTextures(3, surfaces_.data());
    gl_.DeleteRenderbuffers(1, &depth_);
}

// [state]
void MinimalEngine::setState(const Pass& pass) const
{
    const bool first = pass.depth == Depth::write;
    gl_.DepthFunc(first ? GL_LESS : GL_EQUAL);
    gl_.DepthMask(first ? GL_TRUE : GL_FALSE);
    if (pass.blend == Blend::replace) return gl_.Disable(GL_BLEND);
    gl_.Enable(GL_BLEND);
    if (pass.blend == Blend::add)
        gl_.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
    else
        gl_.BlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_ZERO, GL_ONE);
}
// [end]

GLint MinimalEngine::location(GLuint program, const std::string& name) const
{
    return gl_.GetUniformLocation(program, name.c_str());
}

// [maps]
void MinimalEngine::bindMaps(GLuint program) const
{
    for (size_t i = 0; i < maps_.size(); ++i) {
        const Map& map = maps_[i];
        const std::string k = std::to_string(i);
        if (map.texture) {
            gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
            gl_.BindTexture(map.target, map.texture);
            gl_.Uniform1i(location(program, "fbrdfTable" + k), static_cast<GLint>(i));
        }
        if (map.encoding.ranged) {
            gl_.Uniform3fv(location(program, "fbrdfLower" + k), 1, glm::value_ptr(map.lower));
            gl_.Uniform3fv(location(program, "fbrdfExtent" + k), 1, glm::value_ptr(map.extent));
        }
        if (!map.knots.empty())
            gl_.Uniform3fv(location(program, "fbrdfKnots" + k),
                           static_cast<GLsizei>(map.knots.size()),
                           glm::value_ptr(map.knots.front()));
    }
}
// [end]

// [uniforms]
void MinimalEngine::setUniforms(GLuint program, const Pass& pass, const Frame& frame) const
{
    gl_.UniformMatrix4fv(location(program, "fbrdfModelView"), 1, GL_FALSE,
                         glm::value_ptr(frame.modelView));
    gl_.UniformMatrix4fv(location(program, "fbrdfProjection"), 1, GL_FALSE,
                         glm::value_ptr(frame.projection));
    const glm::vec4 eye(eyeFromProjection(glm::dmat4(frame.projection)));
    gl_.Uniform4fv(location(program, "fbrdfEye"), 1, glm::value_ptr(eye));
    for (size_t t = 0; t < material_.scales.size(); ++t) {
        const Vec3f scale = material_.scales[t] * frame.exposure;
        gl_.Uniform3fv(location(program, "fbrdfScale" + std::to_string(t)), 1,
                       glm::value_ptr(scale));
    }
    std::vector<glm::vec4> vectors;
    for (int i = pass.firstLight; i < pass.firstLight + pass.lightCount; ++i)
        for (const glm::vec4& v :
             lightVectors(frame.lights[static_cast<size_t>(i)], glm::dmat4(1.0)))
            vectors.push_back(v);
    if (!vectors.empty())
        gl_.Uniform4fv(location(program, "fbrdfLights"), static_cast<GLsizei>(vectors.size()),
                       glm::value_ptr(vectors.front()));
    gl_.Uniform1i(location(program, "fbrdfLightCount"), pass.lightCount);
    gl_.Uniform1f(location(program, "fbrdfGain"), static_cast<float>(pass.gain));
    if (!pass.reads) return;
    const auto unit = static_cast<GLint>(maps_.size());
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl_.BindTexture(GL_TEXTURE_2D, surfaces_[static_cast<size_t>(*pass.reads) - 1]);
    gl_.Uniform1i(location(program, "fbrdfRead"), unit);
    gl_.Uniform2f(location(program, "fbrdfReadScale"), 1.0f / static_cast<float>(frame.width),
                  1.0f / static_cast<float>(frame.height));
}
// [end]

// [draw]
Plan MinimalEngine::draw(const Frame& frame)
{
    PlanRequest request;
    request.technique = frame.technique;
    request.lights = static_cast<int>(frame.lights.size());
    request.target = ColourFormat::rgba32f;
    request.transfer = frame.transfer;
    request.signs = hasSigns(material_);
    Plan plan = planPasses(material_.form, request, capabilities_);
    if (!plan.feasible()) return plan;

    makeSurfaces(frame.width, frame.height);
    gl_.Viewport(0, 0, frame.width, frame.height);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.BindVertexArray(vertexArray_);
    const int maxLights = maxLightsInUniforms(material_.form, capabilities_);
    bool surfacesCleared = false;
    for (const Pass& pass : plan.passes) {
        const bool isTarget = pass.writes == Surface::target;
        gl_.BindFramebuffer(
            GL_FRAMEBUFFER,
            isTarget ? frame.framebuffer : framebuffers_[static_cast<size_t>(pass.writes) - 1]);
        setState(pass);
        if (!isTarget && !surfacesCleared) {
            gl_.Clear(GL_DEPTH_BUFFER_BIT);
            surfacesCleared = true;
        }
        const GLuint program = programOf(programSpec(pass, maxLights));
        gl_.UseProgram(program);
        bindMaps(program);
        setUniforms(program, pass, frame);
        gl_.DrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
    }
    gl_.DepthMask(GL_TRUE);  // or the next clear would leave the depth buffer as it is
    gl_.Disable(GL_BLEND);
    return plan;
}
// [end]

}  // namespace fbrdf::porting

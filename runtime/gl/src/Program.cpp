#include "Program.h"

#include "MeshResources.h"

#include <fbrdf/base/Error.h>

#include <algorithm>

namespace fbrdf::gl {
namespace {

// The longest name of ours is fbrdfVertexTextureCoordinate; anything longer is none of ours.
constexpr GLsizei kNameLength = 64;

[[noreturn]] void fail(const std::string& what)
{
    throw Error(ErrorKind::gl, "shader", what);
}

template <class GetLog>
std::string infoLog(GLint length, GetLog getLog)
{
    std::string log(static_cast<size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0;
    getLog(static_cast<GLsizei>(log.size()), &written, log.data());
    log.resize(static_cast<size_t>(std::max(written, 0)));
    while (!log.empty() && log.back() == '\n') log.pop_back();
    return log;
}

Object compiled(const DevicePtr& device, GLenum stage, const std::string& source)
{
    const Functions& gl = device->gl;
    Object shader(device, ObjectKind::shader, gl.CreateShader(stage));
    if (!shader) fail("found no shader object, expected one");
    const GLchar* text = source.c_str();
    gl.ShaderSource(shader.name(), 1, &text, nullptr);
    gl.CompileShader(shader.name());
    GLint ok = GL_FALSE, length = 0;
    gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &ok);
    if (ok) return shader;
    gl.GetShaderiv(shader.name(), GL_INFO_LOG_LENGTH, &length);
    fail("found one that does not compile: " +
         infoLog(length, [&](GLsizei size, GLsizei* written, GLchar* log) {
             gl.GetShaderInfoLog(shader.name(), size, written, log);
         }));
}

bool isSampler(GLenum type)
{
    return type == GL_SAMPLER_2D || type == GL_SAMPLER_3D || type == GL_SAMPLER_1D ||
           type == GL_SAMPLER_2D_ARRAY || type == GL_SAMPLER_CUBE || type == GL_SAMPLER_BUFFER ||
           type == GL_INT_SAMPLER_BUFFER;
}

/// Those of a vertex or shadow hook are the host's to bind.
bool isOurs(const std::string& name)
{
    return name.compare(0, 5, "fbrdf") == 0;
}

std::vector<std::string> activeSamplers(const Functions& gl, GLuint program)
{
    GLint count = 0;
    gl.GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    std::vector<std::string> names;
    for (GLint i = 0; i < count; ++i) {
        GLchar name[kNameLength] = {};
        GLsizei length = 0;
        GLint size = 0;
        GLenum type = GL_NONE;
        gl.GetActiveUniform(program, static_cast<GLuint>(i), kNameLength, &length, &size, &type,
                            name);
        if (isSampler(type) && isOurs(name)) names.emplace_back(name);
    }
    return names;
}

/// Arrays of a mesh that the vertex shader reads.
size_t extraArraysOf(const Functions& gl, GLuint program)
{
    size_t count = 0;
    for (size_t k = 0; k < kExtraArrays; ++k)
        if (gl.GetAttribLocation(program, ("fbrdfExtra" + std::to_string(k)).c_str()) >= 0)
            count = k + 1;
    return count;
}

/// A program that calls what a shadow hook must define.
std::string shadowProbe(const std::string& hook, int glsl)
{
    SurfaceInputs inputs;
    inputs.shadowHook = hook;
    Form form;
    form.terms.emplace_back();
    ProgramSpec spec;
    spec.parts = {{0, {}, false}};
    spec.lit = true;
    spec.lightSlots = 1;
    return fragmentSource(form, {}, spec, glsl, inputs);
}

std::string keyOf(const ProgramSpec& spec)
{
    std::string key = (spec.lit ? "l" : "u") + std::to_string(spec.lightSlots);
    if (spec.reads) key += 'r';
    if (spec.clustered) key += 'c';
    if (spec.gained) key += 'g';
    key += static_cast<char>('0' + static_cast<int>(spec.transfer));
    for (const Part& part : spec.parts) {
        key += ';' + std::to_string(part.term) + (part.scaled ? "s" : "");
        for (const int factor : part.factors) key += ',' + std::to_string(factor);
    }
    return key;
}

}  // namespace

const Program& ProgramCache::find(const MaterialResources& material, const ProgramSpec& spec,
                                  const SurfaceOptions& surface)
{
    Entry& entry = entryOf(material, spec, surface);
    if (!entry.program)
        throw Error(ErrorKind::gl, "material '" + material.name() + "'", entry.failure);
    return *entry.program;
}

ProgramCache::Entry& ProgramCache::entryOf(const MaterialResources& material,
                                           const ProgramSpec& spec, const SurfaceOptions& surface)
{
    const auto [known, isUnknown] =
        shortcut_.try_emplace(std::to_string(material.id()) + surface.key() + keyOf(spec), nullptr);
    if (!isUnknown) return *known->second;
    const int glsl = device_->capabilities.glsl;
    const SurfaceInputs inputs = surface.inputs(material.isPacked());
    const auto [position, isNew] = entries_.try_emplace(
        {vertexSource(glsl, inputs),
         fragmentSource(material.form(), material.encodings(), spec, glsl, inputs)});
    Entry& entry = position->second;
    known->second = &entry;
    if (!isNew) return entry;
    try {
        entry.program = build(material, position->first);
    } catch (const Error& error) {
        entry.failure = error.what();
    }
    return entry;
}

void ProgramCache::check(const Hooks& hooks)
{
    SurfaceInputs inputs;
    inputs.vertexHook = hooks.vertex;
    const int glsl = device_->capabilities.glsl;
    try {
        compiled(device_, GL_VERTEX_SHADER, vertexSource(glsl, inputs));
        if (!hooks.shadow.empty())
            compiled(device_, GL_FRAGMENT_SHADER, shadowProbe(hooks.shadow, glsl));
    } catch (const Error& error) {
        throw Error(ErrorKind::input, "hooks", error.what());
    }
}

const Object& ProgramCache::vertexShader(const std::string& text)
{
    Object& shader = vertexShaders_[text];
    if (!shader) shader = compiled(device_, GL_VERTEX_SHADER, text);
    return shader;
}

Object ProgramCache::linked(const Text& text, const MaterialResources& material)
{
    const Functions& gl = device_->gl;
    const Object& vertexShader = this->vertexShader(text.vertex);
    const Object fragmentShader = compiled(device_, GL_FRAGMENT_SHADER, text.fragment);
    Object program = createObject(device_, ObjectKind::program);
    gl.AttachShader(program.name(), vertexShader.name());
    gl.AttachShader(program.name(), fragmentShader.name());
    gl.BindAttribLocation(program.name(), kPosition, "fbrdfVertex");
    gl.BindAttribLocation(program.name(), kNormal, "fbrdfVertexNormal");
    gl.BindAttribLocation(program.name(), kTangent, "fbrdfVertexTangent");
    gl.BindAttribLocation(program.name(), kTextureCoordinate, "fbrdfVertexTextureCoordinate");
    for (GLuint k = 0; k < kExtraArrays; ++k)
        gl.BindAttribLocation(program.name(), kExtra + k,
                              ("fbrdfExtra" + std::to_string(k)).c_str());
    gl.LinkProgram(program.name());
    label(*device_, ObjectKind::program, program, material.form().name);
    GLint ok = GL_FALSE, length = 0;
    gl.GetProgramiv(program.name(), GL_LINK_STATUS, &ok);
    if (ok) return program;
    gl.GetProgramiv(program.name(), GL_INFO_LOG_LENGTH, &length);
    fail("found one that does not link: " +
         infoLog(length, [&](GLsizei size, GLsizei* written, GLchar* log) {
             gl.GetProgramInfoLog(program.name(), size, written, log);
         }));
}

std::unique_ptr<Program> ProgramCache::build(const MaterialResources& material, const Text& text)
{
    const Functions& gl = device_->gl;
    auto result = std::make_unique<Program>();
    result->object = linked(text, material);
    const GLuint program = result->object.name();
    const auto samplers = activeSamplers(gl, program);
    const int room = device_->capabilities.maxTextureUnits - device_->firstTextureUnit;
    if (static_cast<int>(samplers.size()) > room)
        fail("found " + std::to_string(samplers.size()) +
             " textures in one pass, expected at most " + std::to_string(room));
    const auto location = [&](const std::string& name) {
        return gl.GetUniformLocation(program, name.c_str());
    };
    // Samplers keep their units for good; the caller puts the current program back.
    gl.UseProgram(program);
    int nextUnit = 0;
    const auto unitOf = [&](const std::string& name) {
        if (std::find(samplers.begin(), samplers.end(), name) == samplers.end()) return -1;
        gl.Uniform1i(location(name), device_->firstTextureUnit + nextUnit);
        return nextUnit++;
    };
    result->modelView = location("fbrdfModelView");
    result->projection = location("fbrdfProjection");
    result->eye = location("fbrdfEye");
    result->lights = location("fbrdfLights");
    result->lightCount = location("fbrdfLightCount");
    result->lightNumbers = location("fbrdfLightNumbers");
    result->readScale = location("fbrdfReadScale");
    result->gain = location("fbrdfGain");
    result->normalMapUnit = unitOf("fbrdfNormalMap");
    result->extraArrays = extraArraysOf(gl, program);
    result->readUnit = unitOf("fbrdfRead");
    result->clusters = {unitOf("fbrdfLightBuffer"),   unitOf("fbrdfLightIndices"),
                        unitOf("fbrdfLightLists"),    unitOf("fbrdfLightNumbers"),
                        location("fbrdfClusterGrid"), location("fbrdfClusterScale")};
    result->instancesUnit = unitOf("fbrdfInstances");
    result->parametersUnit = unitOf("fbrdfParameters");
    result->material = findUniforms(material, program);
    for (size_t i = 0; i < material.tables().size(); ++i)
        result->tableUnits.push_back(unitOf("fbrdfTable" + std::to_string(i)));
    result->lookups = countLookups(text.fragment, samplers);
    return result;
}

}  // namespace fbrdf::gl

#include "Program.h"

#include "MeshResources.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>

namespace fbrdf::gl {
namespace {

// The longest name of ours is fbrdfVertexTextureCoordinate; a longer one is the host's.
constexpr GLsizei kNameLength = 64;

[[noreturn]] void failShader(const std::string& what)
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

bool isSampler(GLenum type)
{
    return type == GL_SAMPLER_2D || type == GL_SAMPLER_3D || type == GL_SAMPLER_1D ||
           type == GL_SAMPLER_2D_ARRAY || type == GL_SAMPLER_CUBE || type == GL_SAMPLER_BUFFER ||
           type == GL_INT_SAMPLER_BUFFER;
}

/// Samplers of a vertex or shadow hook are the host's to bind.
bool isOurs(const std::string& name)
{
    return name.compare(0, 5, "fbrdf") == 0;
}

std::vector<std::string> activeSamplers(const Functions& gl, GLuint program)
{
    // Names of the host may be longer than the buffer: GL cuts them, and they are skipped anyway.
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

/// The number of extra arrays of a mesh that the vertex shader reads.
size_t extraArraysOf(const Functions& gl, GLuint program)
{
    size_t count = 0;
    for (size_t k = 0; k < kExtraArrays; ++k)
        if (gl.GetAttribLocation(program, ("fbrdfExtra" + std::to_string(k)).c_str()) >= 0)
            count = k + 1;
    return count;
}

/// Puts the attributes where meshes have them (Attribute).
void bindAttributes(const Functions& gl, GLuint program)
{
    gl.BindAttribLocation(program, kPosition, "fbrdfVertex");
    gl.BindAttribLocation(program, kNormal, "fbrdfVertexNormal");
    gl.BindAttribLocation(program, kTangent, "fbrdfVertexTangent");
    gl.BindAttribLocation(program, kTextureCoordinate, "fbrdfVertexTextureCoordinate");
    for (GLuint k = 0; k < kExtraArrays; ++k)
        gl.BindAttribLocation(program, kExtra + k, ("fbrdfExtra" + std::to_string(k)).c_str());
}

void link(const Device& device, const Object& program, const std::string& name)
{
    const Functions& gl = device.gl;
    gl.LinkProgram(program.name());
    label(device, ObjectKind::program, program, name);
    GLint ok = GL_FALSE, length = 0;
    gl.GetProgramiv(program.name(), GL_LINK_STATUS, &ok);
    if (ok) return;
    gl.GetProgramiv(program.name(), GL_INFO_LOG_LENGTH, &length);
    failShader("found one that does not link: " +
               infoLog(length, [&](GLsizei size, GLsizei* written, GLchar* log) {
                   gl.GetProgramInfoLog(program.name(), size, written, log);
               }));
}

/// Texture units of the samplers that a program uses, from the device's first on. Samplers keep
/// their units for good.
class Units {
public:
    Units(const Device& device, GLuint program)
        : device_(device), program_(program), samplers_(activeSamplers(device.gl, program))
    {
        const int room = device.capabilities.maxTextureUnits - device.firstTextureUnit;
        if (static_cast<int>(samplers_.size()) > room)
            failShader(Found(std::to_string(samplers_.size()) + " textures in one pass")
                           .expected("at most " + std::to_string(room)));
    }
    const std::vector<std::string>& samplers() const { return samplers_; }
    /// -1 where the program has no such sampler.
    int next(const std::string& name)
    {
        if (std::find(samplers_.begin(), samplers_.end(), name) == samplers_.end()) return -1;
        device_.gl.Uniform1i(device_.gl.GetUniformLocation(program_, name.c_str()),
                             device_.firstTextureUnit + used_);
        return used_++;
    }

private:
    const Device& device_;
    GLuint program_;
    std::vector<std::string> samplers_;
    int used_ = 0;
};

void findLocations(const Functions& gl, Program& result)
{
    const auto location = [&](const char* name) {
        return gl.GetUniformLocation(result.object.name(), name);
    };
    result.modelView = location("fbrdfModelView");
    result.projection = location("fbrdfProjection");
    result.eye = location("fbrdfEye");
    result.lights = location("fbrdfLights");
    result.lightCount = location("fbrdfLightCount");
    result.lightNumbers = location("fbrdfLightNumbers");
    result.readScale = location("fbrdfReadScale");
    result.gain = location("fbrdfGain");
    result.lobes.toEnvironment = location("fbrdfToEnvironment");
    result.lobes.scale = location("fbrdfEnvironmentScale");
    result.lobes.rows = location("fbrdfLobes");
    result.lobes.bend = location("fbrdfLobeBend");
    result.lobes.areaLights = location("fbrdfAreaLights");
    result.lobes.areaLightCount = location("fbrdfAreaLightCount");
    result.lobes.lattice = location("fbrdfSampleLattice");
    result.clusters.grid = location("fbrdfClusterGrid");
    result.clusters.scale = location("fbrdfClusterScale");
    result.areas.grid = location("fbrdfAreaGrid");
    result.areas.scale = location("fbrdfAreaScale");
}

/// The program must be current.
void assignUnits(Units& units, Program& result, size_t tables)
{
    result.normalMapUnit = units.next("fbrdfNormalMap");
    result.readUnit = units.next("fbrdfRead");
    result.clusters.lightsUnit = units.next("fbrdfLightBuffer");
    result.clusters.indicesUnit = units.next("fbrdfLightIndices");
    result.clusters.listsUnit = units.next("fbrdfLightLists");
    result.clusters.numbersUnit = units.next("fbrdfLightNumbers");
    result.areas.lightsUnit = units.next("fbrdfAreaBuffer");
    result.areas.indicesUnit = units.next("fbrdfAreaIndices");
    result.areas.listsUnit = units.next("fbrdfAreaLists");
    result.lobes.rowsUnit = units.next("fbrdfLobeRows");
    result.lobes.mapUnit = units.next("fbrdfEnvironment");
    result.instancesUnit = units.next("fbrdfInstances");
    result.parametersUnit = units.next("fbrdfParameters");
    for (size_t i = 0; i < tables; ++i)
        result.tableUnits.push_back(units.next("fbrdfTable" + std::to_string(i)));
}

}  // namespace

Object compiledShader(const DevicePtr& device, GLenum stage, const std::string& source)
{
    const Functions& gl = device->gl;
    Object shader(device, ObjectKind::shader, gl.CreateShader(stage));
    // A lost context returns 0.
    if (!shader) failShader(Found("no shader object").expected("one"));
    const GLchar* text = source.c_str();
    gl.ShaderSource(shader.name(), 1, &text, nullptr);
    gl.CompileShader(shader.name());
    GLint ok = GL_FALSE, length = 0;
    gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &ok);
    if (ok) return shader;
    gl.GetShaderiv(shader.name(), GL_INFO_LOG_LENGTH, &length);
    failShader("found one that does not compile: " +
               infoLog(length, [&](GLsizei size, GLsizei* written, GLchar* log) {
                   gl.GetShaderInfoLog(shader.name(), size, written, log);
               }));
}

Object linkedShaders(const DevicePtr& device, const Object& vertexShader,
                     const Object& fragmentShader, const std::string& name)
{
    const Functions& gl = device->gl;
    Object program = createObject(device, ObjectKind::program);
    gl.AttachShader(program.name(), vertexShader.name());
    gl.AttachShader(program.name(), fragmentShader.name());
    bindAttributes(gl, program.name());
    // Locations are the same in all programs, so that a vertex array fits each of them.
    link(*device, program, name);
    return program;
}

Object linkedCompute(const DevicePtr& device, const std::string& source, const std::string& name)
{
    const Object shader = compiledShader(device, GL_COMPUTE_SHADER, source);
    Object program = createObject(device, ObjectKind::program);
    device->gl.AttachShader(program.name(), shader.name());
    link(*device, program, name);
    return program;
}

Program linkedProgram(const DevicePtr& device, const MaterialResources& material,
                      const Object& vertexShader, const std::string& fragment)
{
    Program result;
    // The program keeps what it needs of the shaders; they may be deleted.
    result.object =
        linkedShaders(device, vertexShader, compiledShader(device, GL_FRAGMENT_SHADER, fragment),
                      material.form().name);
    const GLuint program = result.object.name();
    Units units(*device, program);
    // Uniforms can be set of the current program only.
    device->gl.UseProgram(program);
    findLocations(device->gl, result);
    assignUnits(units, result, material.tables().size());
    result.extraArrays = extraArraysOf(device->gl, program);
    result.material = findUniforms(material, program);
    // Samplers that the linker removed cost nothing, so what is left active is counted.
    result.lookups = countLookups(fragment, units.samplers());
    return result;
}

}  // namespace fbrdf::gl

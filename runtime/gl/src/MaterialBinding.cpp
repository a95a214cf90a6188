#include "MaterialUniforms.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/gl/MaterialBinding.h>
#include <fbrdf/plan/Plan.h>
#include <fbrdf/shaders/LobeRows.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace fbrdf::gl {
namespace {

void checkAlive(const Device& device)
{
    if (!device.alive)
        throw Error(ErrorKind::gl, "binding", Found("an abandoned context").expected("a live one"));
}

}  // namespace

std::string materialFunctions(const GpuMaterial& material, int glsl, int maxLights)
{
    const MaterialResources& resources = material.resources();
    return fbrdf::materialFunctions(resources.form(), resources.encodings(), glsl, maxLights);
}

std::string samplingFunctions(const GpuMaterial& material, int glsl)
{
    const MaterialResources& resources = material.resources();
    resources.lobes().wait();
    const LobeTable* const table = resources.lobes().find(0);
    if (!table)
        throw Error(ErrorKind::gl, "material '" + material.name() + "'",
                    resources.lobes().whyNot());
    const int vectors = wholeShare(layoutOf(*table)).vectors(),
              room = freeUniformVectors(resources.form(), resources.device()->capabilities);
    if (vectors > room)
        throw Error(ErrorKind::gl, "material '" + material.name() + "'",
                    Found("lobes in " + std::to_string(vectors) + " vectors of uniforms")
                        .expected("at most the " + std::to_string(room) + " that there are"));
    return fbrdf::samplingFunctions(layoutOf(*table), glsl);
}

/// Where a program wants the lobes by which it samples, and what they are.
struct BoundLobes {
    GLint rows = -1, bend = -1;  ///< -1 where a program has no such uniform
    std::vector<glm::vec4> values = {};
    glm::vec2 bendValue{0.0f};

    BoundLobes() = default;
    BoundLobes(const MaterialResources& material, GLuint program);
    void set(const Functions& gl) const;
};

BoundLobes::BoundLobes(const MaterialResources& material, GLuint program)
{
    // The functions that the program contains have been written for this table.
    const LobeTable* const table = material.isPacked() ? nullptr : material.lobes().known();
    if (!table) return;
    const Functions& gl = material.device()->gl;
    rows = gl.GetUniformLocation(program, "fbrdfLobes");
    bend = gl.GetUniformLocation(program, "fbrdfLobeBend");
    values = lobeRows(*table, wholeShare(layoutOf(*table)));
    bendValue = lobeBend(*table);
}

void BoundLobes::set(const Functions& gl) const
{
    if (rows >= 0)
        gl.Uniform4fv(rows, static_cast<GLsizei>(values.size()), glm::value_ptr(values.front()));
    if (bend >= 0) gl.Uniform2f(bend, bendValue.x, bendValue.y);
}

struct MaterialBinding::State {
    std::shared_ptr<const GpuMaterial> material;
    GLuint program = 0;
    MaterialUniforms uniforms;
    BoundLobes lobes;

    const MaterialResources& resources() const { return material->resources(); }
    const Device& device() const { return *resources().device(); }
};

MaterialBinding::MaterialBinding(std::shared_ptr<const GpuMaterial> material, uint32_t program)
    : state_(std::make_unique<State>())
{
    state_->material = std::move(material);
    state_->program = program;
    checkAlive(state_->device());
    // Errors from before must not be blamed on the program.
    discardHostErrors(state_->device());
    state_->uniforms = findUniforms(state_->resources(), program);
    state_->lobes = BoundLobes(state_->resources(), program);
    checkErrors(state_->device(), "binding of program " + std::to_string(program));
    const auto& scales = state_->uniforms.scales;
    // Every term has a scale that the linker cannot remove where the functions are called; a
    // program that only samples has lobes.
    if (state_->lobes.rows < 0 &&
        std::all_of(scales.begin(), scales.end(), [](GLint at) { return at < 0; }))
        throw Error(ErrorKind::gl, "binding of program " + std::to_string(program),
                    Found("no uniform of material '" + state_->material->name() + "'")
                        .expected("a linked program that calls its functions"));
}

MaterialBinding::~MaterialBinding() = default;
MaterialBinding::MaterialBinding(MaterialBinding&&) noexcept = default;
MaterialBinding& MaterialBinding::operator=(MaterialBinding&&) noexcept = default;

int MaterialBinding::apply(int firstUnit) const
{
    const Device& device = state_->device();
    checkAlive(device);
    const Functions& gl = device.gl;
    const auto& tables = state_->uniforms.tables;
    const auto used = static_cast<int>(std::count_if(
        tables.begin(), tables.end(), [](const auto& table) { return table.sampler >= 0; }));
    const int room = device.capabilities.maxTextureUnits;
    if (firstUnit < 0 || firstUnit > room - used)
        throw Error(ErrorKind::gl, "binding",
                    Found("first unit " + std::to_string(firstUnit) + " for " +
                          std::to_string(used) + " textures")
                        .expected(std::to_string(room) + " units to suffice"));
    // The program stays current: the host draws with it next, and has its own state afterwards.
    gl.UseProgram(state_->program);
    setUniforms(state_->resources(), state_->uniforms);
    state_->lobes.set(gl);
    // Samplers are set each time: the host may have several materials for one program.
    int unit = firstUnit;
    for (size_t i = 0; i < tables.size(); ++i) {
        if (tables[i].sampler < 0) continue;
        const GpuTable& table = state_->resources().tables()[i];
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        gl.BindTexture(table.target, table.texture.name());
        // A sampler object of the host would override how the texture is filtered.
        if (gl.hasSamplers()) gl.BindSampler(static_cast<GLuint>(unit), 0);
        gl.Uniform1i(tables[i].sampler, unit++);
    }
    return used;
}

}  // namespace fbrdf::gl

#include "Executor.h"

#include "Blending.h"
#include "ReadGuard.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/brdf/SampleLattice.h>
#include <fbrdf/shaders/LobeRows.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <optional>

namespace fbrdf::gl {

namespace {

GLenum functionOf(DepthTest test)
{
    switch (test) {
        case DepthTest::less: return GL_LESS;
        case DepthTest::lessEqual: return GL_LEQUAL;
        case DepthTest::greater: return GL_GREATER;
        case DepthTest::greaterEqual: return GL_GEQUAL;
    }
    return GL_LESS;
}

void checkArrays(const MeshResources& mesh, const Program& program)
{
    for (size_t k = 0; k < program.extraArrays; ++k)
        if (!mesh.has(static_cast<GLuint>(kExtra + k)))
            throw Error(ErrorKind::usage, "item",
                        Found("a mesh without extra array " + std::to_string(k))
                            .expected("what its vertex hook reads"));
}

}  // namespace

int Executor::draw(const Drawable& item, const ReadyPlan& ready, const EyeLights& lights)
{
    const Plan& plan = ready.plan;
    FBRDF_ASSERT(ready.programs.size(), ==, plan.passes.size());
    // Checked before the first pass, so that no half of an item is drawn.
    for (const Program* program : ready.programs) checkArrays(item.mesh, *program);
    lights_ = &lights;
    surfaces_ = ready.surfaces;
    program_ = nullptr;
    depthCleared_ = false;
    written_ = changed_ = {};
    int maxLookups = 0;
    const bool resolves = surfaces_ && surfaces_->isMultisampled();
    std::optional<ReadFramebufferGuard> reading;
    if (resolves) reading.emplace(device_);
    // Passes of an item differ in program and state, never in arrays.
    const MeshBinding binding(item.mesh);
    for (size_t i = 0; i < plan.passes.size(); ++i) {
        const Pass& pass = plan.passes[i];
        const DebugGroup group(device_, "fbrdf pass " + std::to_string(i + 1) + " of " +
                                            std::to_string(plan.passes.size()));
        if (resolves) resolveRead(pass);
        bindSurface(pass);
        setBlend(gl_, pass.blend);
        setDepth(pass.depth);
        if (pass.writes != Surface::target) clearSurface(pass);
        const Program& program = *ready.programs[i];
        // Passes of one item often share a program; only lights and gain differ then.
        if (program_ != &program) useProgram(item, program);
        if (program.readUnit >= 0)
            state_.bindTexture(program.readUnit, GL_TEXTURE_2D, surfaces_->texture(*pass.reads));
        if (program.gain >= 0) gl_.Uniform1f(program.gain, static_cast<float>(pass.gain));
        setLights(pass, program);
        if (program.lobes.rows >= 0) setLobes(*ready.lobes, pass, program);
        if (program.lobes.areaLightCount >= 0) setAreaLights(pass, program);
        setScissor(pass);
        const int lookups =
            program.lookups.once + program.lookups.perLight * lightsOf(pass, program);
        const PassEvent event{item.material.name(), static_cast<int>(i),
                              static_cast<int>(plan.passes.size()), &pass, lookups};
        if (device_.passes.begins) device_.passes.begins(event);
        item.mesh.draw(item.instances.count);
        if (device_.passes.ends) device_.passes.ends(event);
        maxLookups = std::max(maxLookups, lookups);
    }
    state_.setScissor(nullptr);
    return maxLookups;
}

void Executor::bindSurface(const Pass& pass)
{
    if (!device_.capabilities.framebufferObjects) return;
    // Without framebuffer objects a plan has no surfaces, and the window is bound.
    gl_.BindFramebuffer(gl_.drawFramebuffer(), pass.writes == Surface::target
                                                   ? request_.target.framebuffer
                                                   : surfaces_->framebuffer(pass.writes));
}

/// All surfaces share one depth buffer, which the items before this one have left. Samples that
/// this item does not cover are 0, alpha too, so that the mean tells how many it does.
void Executor::clearSurface(const Pass& pass)
{
    if (!depthCleared_) gl_.Clear(GL_DEPTH_BUFFER_BIT);
    depthCleared_ = true;
    bool& written = written_[static_cast<size_t>(pass.writes)];
    if (!written && surfaces_->isMultisampled()) {
        constexpr GLfloat kNothing[4] = {};
        gl_.ClearBufferfv(GL_COLOR, 0, kNothing);
    }
    written = changed_[static_cast<size_t>(pass.writes)] = true;
}

void Executor::resolveRead(const Pass& pass)
{
    if (!pass.reads || !changed_[static_cast<size_t>(*pass.reads)]) return;
    changed_[static_cast<size_t>(*pass.reads)] = false;
    state_.setScissor(nullptr);
    surfaces_->resolve(*pass.reads);
}

void Executor::setDepth(Depth depth)
{
    // The pass that writes depth decides what is visible; the others draw where depth is equal,
    // which holds because all programs of an item compute positions by the same text (invariant).
    gl_.DepthFunc(depth == Depth::write ? functionOf(request_.view.depth.test) : GL_EQUAL);
    gl_.DepthMask(depth == Depth::write ? GL_TRUE : GL_FALSE);
}

void Executor::useProgram(const Drawable& item, const Program& program)
{
    gl_.UseProgram(program.object.name());
    program_ = &program;
    // Uniforms belong to the program, which several materials may share: they are set each time.
    setMatrices(item, program);
    bindTables(item.material, program);
    setUniforms(item.material, program.material);
    if (program.instancesUnit >= 0)
        state_.bindTexture(program.instancesUnit, GL_TEXTURE_BUFFER, item.instances.texture);
    if (program.parametersUnit >= 0)
        state_.bindTexture(program.parametersUnit, GL_TEXTURE_BUFFER, item.material.parameters());
    if (program.normalMapUnit >= 0)
        state_.bindTexture(program.normalMapUnit, GL_TEXTURE_2D, item.surface.normalMap);
    setEnvironment(item.material, program);
    // After ours and with the program in use: the host sets its own by plain glUniform.
    if (item.surface.hooks && item.surface.hooks->get().setUniforms)
        item.surface.hooks->get().setUniforms(program.object.name());
    if (program.readScale >= 0)
        gl_.Uniform2f(program.readScale, 1.0f / static_cast<float>(request_.target.width),
                      1.0f / static_cast<float>(request_.target.height));
}

void Executor::setMatrices(const Drawable& item, const Program& program)
{
    if (program.modelView >= 0) {
        const glm::mat4 matrix = modelView(request_.view, item.model);
        gl_.UniformMatrix4fv(program.modelView, 1, GL_FALSE, glm::value_ptr(matrix));
    }
    gl_.UniformMatrix4fv(program.projection, 1, GL_FALSE, glm::value_ptr(request_.view.projection));
    if (program.eye >= 0) gl_.Uniform4fv(program.eye, 1, glm::value_ptr(request_.eyePoint));
}

void Executor::bindTables(const MaterialResources& material, const Program& program)
{
    for (size_t i = 0; i < program.tableUnits.size(); ++i) {
        if (program.tableUnits[i] < 0) continue;
        const GpuTable& table = material.tables()[i];
        state_.bindTexture(program.tableUnits[i], table.target, table.texture.name());
        if (table.target == GL_TEXTURE_CUBE_MAP) state_.filterAcrossEdges();
    }
}

void Executor::setLights(const Pass& pass, const Program& program)
{
    const auto first = static_cast<size_t>(pass.firstLight);
    // Location -1 and count 0 are legal for GL, but the pointer to the first light would not be
    // valid.
    if (program.lights >= 0 && pass.lightCount > 0)
        gl_.Uniform4fv(program.lights, kVectorsPerLight * pass.lightCount,
                       glm::value_ptr(lights_->vectors[first].front()));
    // Programs that read lists take number and places of lights from buffers.
    if (program.clusters.listsUnit >= 0) {
        setClusters(program.clusters, *request_.clusters, lists_);
        gl_.Uniform1i(program.lightCount, request_.clusters->everywhere);
        return;
    }
    if (program.lightNumbers >= 0 && pass.lightCount > 0)
        gl_.Uniform1iv(program.lightNumbers, pass.lightCount, &lights_->numbers[first]);
    if (program.lightCount >= 0) gl_.Uniform1i(program.lightCount, pass.lightCount);
}

void Executor::setClusters(const Program::ClusterUniforms& uniforms, const LightClusters& clusters,
                           const ClusterBuffers& buffers)
{
    const ClusterGrid& grid = clusters.grid;
    state_.bindTexture(uniforms.lightsUnit, GL_TEXTURE_BUFFER, buffers.lights.texture());
    state_.bindTexture(uniforms.indicesUnit, GL_TEXTURE_BUFFER, buffers.indices.texture());
    state_.bindTexture(uniforms.listsUnit, GL_TEXTURE_BUFFER, buffers.lists.texture());
    if (uniforms.numbersUnit >= 0)
        state_.bindTexture(uniforms.numbersUnit, GL_TEXTURE_BUFFER, buffers.numbers.texture());
    gl_.Uniform3i(uniforms.grid, grid.columns, grid.rows, grid.slices);
    gl_.Uniform4f(uniforms.scale,
                  static_cast<float>(grid.columns) / static_cast<float>(request_.target.width),
                  static_cast<float>(grid.rows) / static_cast<float>(request_.target.height),
                  clusters.sliceScale, clusters.sliceBias);
}

void Executor::setEnvironment(const MaterialResources& material, const Program& program)
{
    const EyeEnvironment& environment = request_.environment;
    if (program.lobes.rowsUnit >= 0)
        state_.bindTexture(program.lobes.rowsUnit, GL_TEXTURE_BUFFER, material.lobeRows());
    if (program.lobes.mapUnit < 0) return;
    const bool sampled = program.lobes.lattice >= 0;
    state_.bindTexture(program.lobes.mapUnit, GL_TEXTURE_CUBE_MAP,
                       sampled ? environment.map->unfiltered() : environment.map->texture());
    state_.filterAcrossEdges();
    gl_.UniformMatrix3fv(program.lobes.toEnvironment, 1, GL_FALSE,
                         glm::value_ptr(environment.fromEye));
    glm::vec4 scale = environment.scale;
    if (sampled) {
        scale.w = static_cast<float>(environment.map->size());
        gl_.Uniform2f(program.lobes.lattice, static_cast<float>(environment.samples),
                      static_cast<float>(latticeStep(environment.samples)));
    }
    gl_.Uniform4fv(program.lobes.scale, 1, glm::value_ptr(scale));
}

/// Passes that share a program add different lobes.
void Executor::setLobes(const LobeTable& table, const Pass& pass, const Program& program)
{
    const std::vector<glm::vec4> rows = lobeRows(table, pass.lobes);
    gl_.Uniform4fv(program.lobes.rows, static_cast<GLsizei>(rows.size()),
                   glm::value_ptr(rows.front()));
    const glm::vec2 bend = lobeBend(table);
    if (program.lobes.bend >= 0) gl_.Uniform2f(program.lobes.bend, bend.x, bend.y);
}

void Executor::setAreaLights(const Pass& pass, const Program& program)
{
    if (program.areas.listsUnit >= 0) {
        setClusters(program.areas, *request_.areaClusters, areaLists_);
        gl_.Uniform1i(program.lobes.areaLightCount, request_.areaClusters->everywhere);
        return;
    }
    const LobeShare& share = pass.lobes;
    gl_.Uniform1i(program.lobes.areaLightCount, share.areaCount);
    gl_.Uniform4fv(program.lobes.areaLights, kVectorsPerAreaLight * share.areaCount,
                   glm::value_ptr(lights_->areas[static_cast<size_t>(share.firstArea)].front()));
}

int Executor::lightsOf(const Pass& pass, const Program& program) const
{
    if (program.lobes.lattice >= 0) return pass.lobes.samples;
    return program.clusters.listsUnit >= 0 ? request_.clusters->longest : pass.lightCount;
}

// Only a pass that adds light may leave out pixels that its lights do not reach: any other also
// writes depth, replaces or multiplies.
void Executor::setScissor(const Pass& pass)
{
    const int width = request_.target.width, height = request_.target.height;
    const bool mayLeaveOut = pass.lit && pass.lightCount > 0 && pass.blend == Blend::add &&
                             !pass.reads && pass.lobes.isEmpty() && !request_.clusters;
    if (!mayLeaveOut) return state_.setScissor(nullptr);
    PixelRect rect;
    for (int i = 0; i < pass.lightCount; ++i)
        rect =
            enclosing(rect, pixelBounds(lights_->vectors[static_cast<size_t>(pass.firstLight + i)],
                                        glm::dmat4(request_.view.projection), width, height));
    // Without a scissor the driver has less to do.
    const bool isWhole = rect.width == width && rect.height == height;
    state_.setScissor(isWhole ? nullptr : &rect);
}

}  // namespace fbrdf::gl

#include "Boundary.h"
#include "Files.h"

#include <algorithm>

using namespace fbrdf::capi;

namespace {

// What version 0.1 began with; fields after it are younger.
constexpr size_t kFirstMesh = offsetof(fbrdf_mesh_desc, handedness);

fbrdf_severity severityOf(fbrdf::gl::Severity severity)
{
    switch (severity) {
        case fbrdf::gl::Severity::note: return FBRDF_NOTE;
        case fbrdf::gl::Severity::warning: return FBRDF_WARNING;
        case fbrdf::gl::Severity::error: return FBRDF_ERROR;
    }
    return FBRDF_ERROR;
}

fbrdf::gl::RendererOptions optionsOf(const fbrdf_renderer_desc& desc)
{
    fbrdf::gl::RendererOptions options;
    options.load = desc.load;
    options.loadUser = desc.load_user;
    if (desc.log.function)
        options.log = [log = desc.log](fbrdf::gl::Severity severity, const std::string& text) {
            log.function(log.user, severityOf(severity), FBRDF_OK, text.c_str());
        };
    options.debugLabels = desc.no_debug_labels == 0;
    options.state = enumerator(desc.state_mode, fbrdf::gl::StateMode::leave, "state_mode");
    if (desc.first_texture_unit > 1024)
        throw Failure(FBRDF_ERROR_ARGUMENT, "first_texture_unit: found " +
                                                std::to_string(desc.first_texture_unit) +
                                                ", expected a texture unit");
    options.firstTextureUnit = static_cast<int>(desc.first_texture_unit);
    return options;
}

void checkVersion(const fbrdf_renderer_desc& desc)
{
    if ((desc.api_version >> 16) != (FBRDF_API_VERSION >> 16) ||
        desc.api_version > FBRDF_API_VERSION)
        throw Failure(FBRDF_ERROR_VERSION, "renderer: found api_version " +
                                               std::to_string(desc.api_version >> 16) + "." +
                                               std::to_string(desc.api_version & 0xffffu) +
                                               ", expected a program of at most " +
                                               std::to_string(FBRDF_API_VERSION >> 16) + "." +
                                               std::to_string(FBRDF_API_VERSION & 0xffffu));
}

/// count vectors, one component after the other; none where there are no numbers.
template <class Vector>
std::vector<Vector> vectors(const float* numbers, uint32_t count)
{
    std::vector<Vector> result(numbers ? count : 0);
    if (!result.empty()) std::memcpy(result.data(), numbers, result.size() * sizeof result[0]);
    return result;
}

fbrdf::gl::MeshData meshOf(const fbrdf_mesh_desc& desc)
{
    required(desc.positions, "positions");
    required(desc.normals, "normals");
    required(desc.indices, "indices");
    const uint32_t count = desc.vertex_count;
    fbrdf::gl::MeshData mesh{vectors<fbrdf::Vec3f>(desc.positions, count),
                             vectors<fbrdf::Vec3f>(desc.normals, count),
                             vectors<fbrdf::Vec3f>(desc.tangents, count),
                             {desc.indices, desc.indices + desc.index_count},
                             vectors<glm::vec2>(desc.texture_coordinates, count),
                             vectors<float>(desc.handedness, count)};
    if (desc.extra_count > 0) required(desc.extra, "extra");
    if (desc.extra_count > fbrdf::gl::kExtraArrays)
        throw Failure(FBRDF_ERROR_ARGUMENT,
                      "extra_count: found " + std::to_string(desc.extra_count) +
                          ", expected at most " + std::to_string(fbrdf::gl::kExtraArrays));
    for (uint32_t k = 0; k < desc.extra_count; ++k)
        mesh.extra.push_back(vectors<glm::vec4>(&required(desc.extra[k], "extra"), count));
    return mesh;
}

fbrdf::gl::Hooks hooksOf(const fbrdf_hooks_desc& desc)
{
    fbrdf::gl::Hooks hooks;
    if (desc.vertex) hooks.vertex = desc.vertex;
    if (desc.shadow) hooks.shadow = desc.shadow;
    if (desc.reach != 0.0f) hooks.reach = desc.reach;
    if (desc.shadow_uniforms > 0x7fffffffu)
        throw Failure(FBRDF_ERROR_ARGUMENT, "shadow_uniforms: found " +
                                                std::to_string(desc.shadow_uniforms) +
                                                ", expected a number of uniforms");
    hooks.shadowUniforms = static_cast<int>(desc.shadow_uniforms);
    if (desc.set_uniforms)
        hooks.setUniforms = [set = desc.set_uniforms, user = desc.user](uint32_t program) {
            set(user, program);
        };
    return hooks;
}

fbrdf::gl::MaterialOptions optionsOf(const fbrdf_material_desc& desc)
{
    fbrdf::gl::MaterialOptions options;
    options.lookUp = enumerator(desc.look_up, fbrdf::LookUp::cube, "look_up");
    // What an int does not hold is out of range, as the next number is.
    options.mapSize = static_cast<int>(
        std::min(desc.map_size, static_cast<uint32_t>(fbrdf::kLargestMapSize + 1)));
    return options;
}

/// optionsOfCall: called where what it throws becomes a result.
template <class Options>
fbrdf_result createMaterial(fbrdf_renderer* renderer, const fbrdf_brdf* brdf, fbrdf_material** out,
                            Options optionsOfCall)
{
    return created(renderer ? &renderer->shared->log : nullptr, out, [&] {
        const SharedPtr& shared = required(renderer, "renderer").shared;
        const fbrdf::gl::MaterialOptions options = optionsOfCall();
        auto gpu = shared->renderer.createMaterial(required(brdf, "brdf").material, options);
        return new fbrdf_material{shared, std::move(gpu), options, {}};
    });
}

void replace(fbrdf_material& material, const fbrdf::Material& by)
{
    auto gpu = material.shared->renderer.createMaterial(by, material.options);
    material.functions.clear();
    material.gpu = std::move(gpu);
}

}  // namespace

uint32_t fbrdf_api_version(void)
{
    return FBRDF_API_VERSION;
}

const char* fbrdf_result_text(fbrdf_result result)
{
    switch (result) {
        case FBRDF_OK: return "done";
        case FBRDF_ERROR_VERSION: return "a descriptor of another version";
        case FBRDF_ERROR_ARGUMENT: return "an argument out of range";
        case FBRDF_ERROR_INPUT: return "unreadable or invalid input";
        case FBRDF_ERROR_GL: return "the OpenGL context cannot do it";
        case FBRDF_ERROR_MEMORY: return "out of memory";
        case FBRDF_ERROR_INTERNAL: return "a fault of the library";
    }
    return "no result of this library";
}

fbrdf_result fbrdf_renderer_create(const fbrdf_renderer_desc* desc, fbrdf_renderer** out)
{
    fbrdf_log log{};
    const bool hasLog = desc && desc->struct_size >= offsetof(fbrdf_renderer_desc, state_mode);
    if (hasLog) log = desc->log;
    return created(&log, out, [&] {
        const fbrdf_renderer_desc known = descriptor(desc, sizeof *desc, "renderer");
        checkVersion(known);
        return new fbrdf_renderer{
            std::make_shared<Shared>(Shared{fbrdf::gl::Renderer(optionsOf(known)), known.log})};
    });
}

void fbrdf_renderer_abandon(fbrdf_renderer* renderer)
{
    if (renderer) renderer->shared->renderer.abandonContext();
}

void fbrdf_renderer_release(fbrdf_renderer* renderer)
{
    delete renderer;
}

fbrdf_result fbrdf_material_create(fbrdf_renderer* renderer, const fbrdf_brdf* brdf,
                                   fbrdf_material** out)
{
    return createMaterial(renderer, brdf, out, [] { return fbrdf::gl::MaterialOptions{}; });
}

fbrdf_result fbrdf_material_create_as(fbrdf_renderer* renderer, const fbrdf_brdf* brdf,
                                      const fbrdf_material_desc* desc, fbrdf_material** out)
{
    return createMaterial(renderer, brdf, out,
                          [desc] { return optionsOf(descriptor(desc, sizeof *desc, "material")); });
}

const char* fbrdf_material_why_native(const fbrdf_material* material)
{
    return material ? fbrdf::gl::whyNative(*material->gpu).c_str() : "";
}

float fbrdf_material_look_up_error(const fbrdf_material* material)
{
    return material ? static_cast<float>(fbrdf::gl::lookUpError(*material->gpu)) : 0.0f;
}

fbrdf_result fbrdf_material_replace(fbrdf_material* material, const fbrdf_brdf* brdf)
{
    return guarded(material ? &material->shared->log : nullptr, [&] {
        replace(required(material, "material"), required(brdf, "brdf").material);
    });
}

fbrdf_result fbrdf_material_load(fbrdf_material* material, const char* path)
{
    return guarded(material ? &material->shared->log : nullptr, [&] {
        replace(required(material, "material"), readFile(&required(path, "path")));
    });
}

void fbrdf_material_release(fbrdf_material* material)
{
    delete material;
}

fbrdf_result fbrdf_mesh_create(fbrdf_renderer* renderer, const fbrdf_mesh_desc* desc,
                               fbrdf_mesh** out)
{
    return created(renderer ? &renderer->shared->log : nullptr, out, [&] {
        const SharedPtr& shared = required(renderer, "renderer").shared;
        return new fbrdf_mesh{
            shared, shared->renderer.createMesh(meshOf(descriptor(desc, kFirstMesh, "mesh")))};
    });
}

void fbrdf_mesh_release(fbrdf_mesh* mesh)
{
    delete mesh;
}

fbrdf_result fbrdf_hooks_create(fbrdf_renderer* renderer, const fbrdf_hooks_desc* desc,
                                fbrdf_hooks** out)
{
    return created(renderer ? &renderer->shared->log : nullptr, out, [&] {
        const SharedPtr& shared = required(renderer, "renderer").shared;
        return new fbrdf_hooks{
            shared, shared->renderer.createHooks(hooksOf(descriptor(desc, sizeof *desc, "hooks")))};
    });
}

void fbrdf_hooks_release(fbrdf_hooks* hooks)
{
    delete hooks;
}

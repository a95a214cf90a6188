#include "Lights.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/plan/LightVectors.h>
#include <fbrdf/shaders/ShaderSource.h>

#include <glm/gtc/type_ptr.hpp>

using namespace fbrdf::capi;

namespace {

// Far above what uniforms have room for (OpenGL 4.5 promises 1024 vec4), far below any overflow.
constexpr uint32_t kMostLights = 1u << 16;

/// The embedded file of a snippet. It is a string literal, so its text ends with a 0.
const char* fileOf(uint32_t snippet)
{
    switch (snippet) {
        case FBRDF_SNIPPET_ANGLES: return "angles.glsl";
        case FBRDF_SNIPPET_PROJECTION: return "projection.glsl";
        case FBRDF_SNIPPET_FRAME: return "frame.glsl";
        case FBRDF_SNIPPET_LIGHTS: return "lights.glsl";
        case FBRDF_SNIPPET_TRANSFER: return "transfer.glsl";
        default: return nullptr;
    }
}

}  // namespace

const char* fbrdf_glsl_snippet(uint32_t snippet)
{
    const char* file = fileOf(snippet);
    return file ? fbrdf::shaderSnippet(file).data() : nullptr;
}

fbrdf_result fbrdf_gpu_material_glsl(fbrdf_gpu_material* gpu_material, const fbrdf_glsl_desc* desc,
                                     const char** text)
{
    return created(logOf(gpu_material), text, [&] {
        const fbrdf_glsl_desc known = descriptor(desc, "glsl");
        const uint32_t version = known.glsl_version == 0 ? 330 : known.glsl_version,
                       lights = known.max_lights == 0 ? 8 : known.max_lights;
        if (lights > kMostLights || version > 1000)
            throw Failure(
                FBRDF_RESULT_ERROR_ARGUMENT,
                "glsl: " + fbrdf::Found("version " + std::to_string(version) + " and " +
                                        std::to_string(lights) + " lights")
                               .expected("at most 1000 and " + std::to_string(kMostLights)));
        // The text has to live as long as the handle, and hosts ask for it again with other
        // numbers.
        const bool sampling = known.sampling != 0;
        const uint64_t key = (uint64_t{version} << 33) | (uint64_t{sampling} << 32) | lights;
        const fbrdf::gl::GpuMaterial& gpu = *required(gpu_material, "gpu_material").gpu;
        std::string functions =
            fbrdf::gl::materialFunctions(gpu, static_cast<int>(version), static_cast<int>(lights));
        if (sampling) functions += fbrdf::gl::samplingFunctions(gpu, static_cast<int>(version));
        return gpu_material->functions.try_emplace(key, std::move(functions)).first->second.c_str();
    });
}

fbrdf_result fbrdf_binding_create(fbrdf_gpu_material* gpu_material, uint32_t program,
                                  fbrdf_binding** out)
{
    return created(logOf(gpu_material), out, [&] {
        required(gpu_material, "gpu_material");
        return new fbrdf_binding{gpu_material->shared,
                                 fbrdf::gl::MaterialBinding(gpu_material->gpu, program)};
    });
}

fbrdf_result fbrdf_binding_apply(fbrdf_binding* binding, uint32_t unit, uint32_t* units_used)
{
    return guarded(logOf(binding), [&] {
        const int used = required(binding, "binding")
                             .binding.apply(unit > kMostLights ? -1 : static_cast<int>(unit));
        if (units_used) *units_used = static_cast<uint32_t>(used);
    });
}

void fbrdf_binding_release(fbrdf_binding* binding)
{
    delete binding;
}

fbrdf_result fbrdf_light_vectors(const fbrdf_light* light, const float to_space[16],
                                 float vectors[12])
{
    return guarded(nullptr, [&] {
        const fbrdf::Light given = lightOf(required(light, "light"));
        if (!isValid(given))
            throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                          "light: " + fbrdf::Found("one that is not valid")
                                          .expected("one that is (fbrdf/plan/Light.h)"));
        const glm::dmat4 matrix(to_space ? glm::make_mat4(to_space) : glm::mat4(1.0f));
        const fbrdf::LightVectors result = fbrdf::lightVectors(given, matrix);
        std::memcpy(&required(vectors, "vectors"), result.data(), 12 * sizeof(float));
    });
}

#include "Boundary.h"

#include <fbrdf/base/Found.h>

#include <functional>

using namespace fbrdf::capi;

namespace {

fbrdf_severity severityOf(fbrdf::gl::Severity severity)
{
    switch (severity) {
        case fbrdf::gl::Severity::note: return FBRDF_SEVERITY_NOTE;
        case fbrdf::gl::Severity::warning: return FBRDF_SEVERITY_WARNING;
        case fbrdf::gl::Severity::error: return FBRDF_SEVERITY_ERROR;
    }
    return FBRDF_SEVERITY_ERROR;
}

/// Empty where the host has no function. What cannot be told for want of memory is not told.
std::function<void(const fbrdf::gl::PassEvent&)> passFunctionOf(fbrdf_pass_function function,
                                                                void* user)
{
    if (!function) return {};
    return [function, user](const fbrdf::gl::PassEvent& event) noexcept {
        try {
            const std::string name(event.material);
            const auto number = [](int value) { return static_cast<uint32_t>(value); };
            const fbrdf_pass_event told{sizeof(fbrdf_pass_event),
                                        number(event.index),
                                        number(event.count),
                                        number(event.lookups),
                                        number(event.pass->firstLight),
                                        number(event.pass->lightCount),
                                        name.c_str()};
            function(user, &told);
        } catch (...) {
        }
    };
}

fbrdf::gl::RendererOptions optionsOf(const fbrdf_renderer_desc& desc)
{
    fbrdf::gl::RendererOptions options;
    options.load = desc.load;
    options.loadUser = desc.load_user;
    if (desc.log.function)
        options.log = [log = desc.log](fbrdf::gl::Severity severity, const std::string& text) {
            log.function(log.user, severityOf(severity), FBRDF_RESULT_OK, text.c_str());
        };
    options.passes = {passFunctionOf(desc.passes.begins, desc.passes.user),
                      passFunctionOf(desc.passes.ends, desc.passes.user)};
    if (desc.idle_programs != 0) options.idlePrograms = desc.idle_programs;
    options.debugLabels = desc.no_debug_labels == 0;
    options.state = enumerator(desc.state_mode, fbrdf::gl::StateMode::leave, "state_mode");
    if (desc.first_texture_unit > 1024)
        throw Failure(
            FBRDF_RESULT_ERROR_ARGUMENT,
            "first_texture_unit: " +
                fbrdf::Found(std::to_string(desc.first_texture_unit)).expected("a texture unit"));
    options.firstTextureUnit = static_cast<int>(desc.first_texture_unit);
    return options;
}

std::string versionText(uint32_t version)
{
    return std::to_string(version >> 16) + "." + std::to_string(version & 0xffffu);
}

void checkVersion(const fbrdf_renderer_desc& desc)
{
    if (desc.api_version < FBRDF_API_OLDEST_VERSION || desc.api_version > FBRDF_API_VERSION)
        throw Failure(
            FBRDF_RESULT_ERROR_VERSION,
            "renderer: " + fbrdf::Found("api_version " + versionText(desc.api_version))
                               .expected("a program of " + versionText(FBRDF_API_OLDEST_VERSION) +
                                         " to " + versionText(FBRDF_API_VERSION)));
}

}  // namespace

uint32_t fbrdf_api_version(void)
{
    return FBRDF_API_VERSION;
}

const char* fbrdf_result_text(fbrdf_result result)
{
    switch (result) {
        case FBRDF_RESULT_OK: return "done";
        case FBRDF_RESULT_ERROR_VERSION: return "a descriptor of another version";
        case FBRDF_RESULT_ERROR_ARGUMENT: return "an argument out of range";
        case FBRDF_RESULT_ERROR_INPUT: return "unreadable or invalid input";
        case FBRDF_RESULT_ERROR_GL: return "the OpenGL context cannot do it";
        case FBRDF_RESULT_ERROR_MEMORY: return "out of memory";
        case FBRDF_RESULT_ERROR_INTERNAL: return "a fault of the library";
    }
    return "no result of this library";
}

fbrdf_result fbrdf_renderer_create(const fbrdf_renderer_desc* desc, fbrdf_renderer** out)
{
    fbrdf_log log{};
    const bool hasLog = desc && desc->struct_size >= offsetof(fbrdf_renderer_desc, state_mode);
    if (hasLog) log = desc->log;
    return created(&log, out, [&] {
        const fbrdf_renderer_desc known = descriptor(desc, "renderer");
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

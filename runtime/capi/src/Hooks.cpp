#include "Boundary.h"

#include <fbrdf/base/Found.h>

using namespace fbrdf::capi;

namespace {

fbrdf::gl::Hooks hooksOf(const fbrdf_hooks_desc& desc)
{
    fbrdf::gl::Hooks hooks;
    if (desc.vertex) hooks.vertex = desc.vertex;
    if (desc.shadow) hooks.shadow = desc.shadow;
    if (desc.reach != 0.0f) hooks.reach = desc.reach;
    if (desc.shadow_uniforms > 0x7fffffffu)
        throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                      "shadow_uniforms: " + fbrdf::Found(std::to_string(desc.shadow_uniforms))
                                                .expected("a number of uniforms"));
    hooks.shadowUniforms = static_cast<int>(desc.shadow_uniforms);
    // The struct may be gone when a draw calls this: function and pointer are copied.
    if (desc.set_uniforms)
        hooks.setUniforms = [set = desc.set_uniforms, user = desc.user](uint32_t program) {
            set(user, program);
        };
    return hooks;
}

}  // namespace

fbrdf_result fbrdf_hooks_create(fbrdf_renderer* renderer, const fbrdf_hooks_desc* desc,
                                fbrdf_hooks** out)
{
    return created(logOf(renderer), out, [&] {
        const SharedPtr& shared = required(renderer, "renderer").shared;
        return new fbrdf_hooks{shared,
                               shared->renderer.createHooks(hooksOf(descriptor(desc, "hooks")))};
    });
}

void fbrdf_hooks_release(fbrdf_hooks* hooks)
{
    delete hooks;
}

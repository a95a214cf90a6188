#include "Boundary.h"

#include <algorithm>
#include <cstdint>

using namespace fbrdf::capi;

namespace {

fbrdf::Panorama panoramaOf(const fbrdf_environment_desc& desc)
{
    // As many texels as some computer can have; the library itself has limits of GL.
    constexpr uint32_t kMost = 1u << 16;
    if (!desc.radiance || desc.width == 0 || desc.height == 0 || desc.width > kMost ||
        desc.height > kMost)
        throw Failure(FBRDF_RESULT_ERROR_ARGUMENT,
                      "environment: " +
                          fbrdf::Found(desc.radiance ? std::to_string(desc.width) + " x " +
                                                           std::to_string(desc.height) + " texels"
                                                     : "neither radiance nor a texture")
                              .expected("one, of 1 to 65536 texels on a side"));
    fbrdf::Panorama panorama{static_cast<int>(desc.width), static_cast<int>(desc.height), {}};
    const size_t texels = size_t(desc.width) * desc.height;
    panorama.texels.reserve(texels);
    for (size_t i = 0; i < texels; ++i)
        panorama.texels.emplace_back(desc.radiance[3 * i], desc.radiance[3 * i + 1],
                                     desc.radiance[3 * i + 2]);
    return panorama;
}

}  // namespace

fbrdf_result fbrdf_environment_create(fbrdf_renderer* renderer, const fbrdf_environment_desc* desc,
                                      fbrdf_environment** out)
{
    return created(logOf(renderer), out, [&] {
        const SharedPtr& shared = required(renderer, "renderer").shared;
        const fbrdf_environment_desc known = descriptor(desc, "environment");
        fbrdf::gl::EnvironmentOptions options;
        // Numbers that no int can represent are refused as other sizes are that are none.
        options.size = static_cast<int>(std::min(known.size, uint32_t(INT32_MAX)));
        options.floats = known.floats != 0;
        options.unfiltered = known.unfiltered != 0;
        options.gradual = known.gradual != 0;
        auto gpu = known.texture
                       ? shared->renderer.createEnvironment(
                             fbrdf::gl::HostEnvironment{known.texture, known.cube != 0}, options)
                       : shared->renderer.createEnvironment(panoramaOf(known), options);
        return new fbrdf_environment{shared, std::move(gpu)};
    });
}

fbrdf_result fbrdf_environment_refine(fbrdf_environment* environment, uint32_t texels,
                                      uint32_t* finished)
{
    return guarded(logOf(environment), [&] {
        fbrdf_environment& known = required(environment, "environment");
        const bool isFinished = known.shared->renderer.refine(*known.gpu, texels);
        if (finished) *finished = isFinished ? 1 : 0;
    });
}

void fbrdf_environment_release(fbrdf_environment* environment)
{
    delete environment;
}

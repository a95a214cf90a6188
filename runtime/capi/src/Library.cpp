#include "Boundary.h"
#include "Files.h"

using namespace fbrdf::capi;

namespace {

const fbrdf_log* logOf(const fbrdf_library* library)
{
    return library ? &library->shared->log : nullptr;
}

void replace(fbrdf_library* library, uint32_t index, const fbrdf::Material& by)
{
    if (index > 0x7fffffffu)
        throw Failure(FBRDF_ERROR_ARGUMENT,
                      "index: found " + std::to_string(index) + ", expected one of the library");
    required(library, "library")
        .shared->renderer.replaceMaterial(*library->gpu, static_cast<int>(index), by);
}

}  // namespace

fbrdf_result fbrdf_library_create(fbrdf_renderer* renderer, uint32_t count,
                                  const fbrdf_brdf* const* brdfs, fbrdf_library** out)
{
    return created(renderer ? &renderer->shared->log : nullptr, out, [&] {
        const SharedPtr& shared = required(renderer, "renderer").shared;
        if (count > 0) required(brdfs, "brdfs");
        std::vector<fbrdf::Material> materials;
        for (uint32_t i = 0; i < count; ++i)
            materials.push_back(required(brdfs[i], "brdfs").material);
        return new fbrdf_library{shared, shared->renderer.createLibrary(materials)};
    });
}

fbrdf_result fbrdf_library_replace(fbrdf_library* library, uint32_t index, const fbrdf_brdf* brdf)
{
    return guarded(logOf(library),
                   [&] { replace(library, index, required(brdf, "brdf").material); });
}

fbrdf_result fbrdf_library_load(fbrdf_library* library, uint32_t index, const char* path)
{
    return guarded(logOf(library),
                   [&] { replace(library, index, readFile(&required(path, "path"))); });
}

const char* fbrdf_library_why_apart(const fbrdf_library* library)
{
    return library ? fbrdf::gl::whyApart(*library->gpu).c_str() : "";
}

void fbrdf_library_release(fbrdf_library* library)
{
    delete library;
}

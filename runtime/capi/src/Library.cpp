#include "Boundary.h"
#include "Uploads.h"

#include <fbrdf/base/Found.h>

using namespace fbrdf::capi;

fbrdf_result fbrdf_library_create(fbrdf_renderer* renderer, uint32_t count,
                                  const fbrdf_material* const* materials, fbrdf_library** out)
{
    return fbrdf_library_create_with(renderer, count, materials, nullptr, out);
}

fbrdf_result fbrdf_library_create_with(fbrdf_renderer* renderer, uint32_t count,
                                       const fbrdf_material* const* materials,
                                       const fbrdf_gpu_material_desc* desc, fbrdf_library** out)
{
    return created(logOf(renderer), out, [&] {
        const SharedPtr& shared = required(renderer, "renderer").shared;
        const auto options = desc ? materialOptionsOf(*desc) : fbrdf::gl::MaterialOptions{};
        if (count > 0) required(materials, "materials");
        // The renderer takes materials side by side, and the handles are anywhere.
        std::vector<fbrdf::Material> copies;
        for (uint32_t i = 0; i < count; ++i)
            copies.push_back(required(materials[i], "materials").material);
        return new fbrdf_library{shared, shared->renderer.createLibrary(copies, options)};
    });
}

fbrdf_result fbrdf_library_replace(fbrdf_library* library, uint32_t index,
                                   const fbrdf_material* material)
{
    return guarded(logOf(library), [&] {
        if (index > INT32_MAX)
            throw Failure(
                FBRDF_RESULT_ERROR_ARGUMENT,
                "index: " + fbrdf::Found(std::to_string(index)).expected("one of the library"));
        required(library, "library")
            .shared->renderer.replaceMaterial(*library->gpu, static_cast<int>(index),
                                              required(material, "material").material);
    });
}

const char* fbrdf_library_why_not_packed(const fbrdf_library* library)
{
    return library ? library->gpu->whyNotPacked().c_str() : "";
}

void fbrdf_library_release(fbrdf_library* library)
{
    delete library;
}

#include "Boundary.h"
#include "Uploads.h"

using namespace fbrdf::capi;

fbrdf_result fbrdf_gpu_material_create(fbrdf_renderer* renderer, const fbrdf_material* material,
                                       const fbrdf_gpu_material_desc* desc,
                                       fbrdf_gpu_material** out)
{
    return created(logOf(renderer), out, [&] {
        const SharedPtr& shared = required(renderer, "renderer").shared;
        const auto options = desc ? materialOptionsOf(*desc) : fbrdf::gl::MaterialOptions{};
        auto gpu =
            shared->renderer.createMaterial(required(material, "material").material, options);
        return new fbrdf_gpu_material{shared, std::move(gpu), options, {}};
    });
}

fbrdf_result fbrdf_gpu_material_replace(fbrdf_gpu_material* gpu_material,
                                        const fbrdf_material* material)
{
    return guarded(logOf(gpu_material), [&] {
        fbrdf_gpu_material& to = required(gpu_material, "gpu_material");
        // The new one is made before the old one goes: where GL refuses it, the old one stays.
        auto gpu =
            to.shared->renderer.createMaterial(required(material, "material").material, to.options);
        to.functions.clear();
        to.gpu = std::move(gpu);
    });
}

const char* fbrdf_gpu_material_why_not_recombined(const fbrdf_gpu_material* gpu_material)
{
    return gpu_material ? gpu_material->gpu->whyNotRecombined().c_str() : "";
}

float fbrdf_gpu_material_look_up_error(const fbrdf_gpu_material* gpu_material)
{
    return gpu_material ? static_cast<float>(gpu_material->gpu->lookUpError()) : 0.0f;
}

float fbrdf_gpu_material_filter_error(const fbrdf_gpu_material* gpu_material)
{
    return gpu_material ? static_cast<float>(gpu_material->gpu->filterError()) : 0.0f;
}

void fbrdf_gpu_material_release(fbrdf_gpu_material* gpu_material)
{
    delete gpu_material;
}

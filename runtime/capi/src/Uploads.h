// Uploads.h - converts how a material is uploaded.
#pragma once
#include "Boundary.h"

#include <algorithm>

namespace fbrdf::capi {

/// Throws Failure as known(); numbers out of range are left to the renderer to refuse.
inline gl::MaterialOptions materialOptionsOf(const fbrdf_gpu_material_desc& given)
{
    const fbrdf_gpu_material_desc desc = descriptor(&given, "gpu_material");
    gl::MaterialOptions options;
    options.lookUp = enumerator(desc.look_up, LookUp::cube, "look_up");
    // Numbers beyond the largest size, also those that no int can represent, are refused alike.
    options.mapSize =
        static_cast<int>(std::min(desc.map_size, static_cast<uint32_t>(kLargestMapSize + 1)));
    options.precise = desc.precise != 0;
    return options;
}

}  // namespace fbrdf::capi

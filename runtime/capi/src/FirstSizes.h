// FirstSizes.h - how long each struct of the ABI was in the oldest version that the library
// accepts. To append a field: put it at the end of the struct, leave `first` as it is, and name the
// new field as `last`. Never change or reorder fields, and keep 0 their default.
#pragma once
#include <fbrdf/fbrdf.h>

#include <cstddef>

namespace fbrdf::capi {

/// Bytes of the first version of T, up to the end of its last field.
template <class T>
constexpr size_t kFirstSize = 0;

// A struct that ends in padding could not grow: the next field would lie where older callers have
// bytes of any value, and sizeof would not tell them apart. So no struct ends in padding.
#define FBRDF_FIRST_SIZE(Struct, first, last)                                                   \
    template <>                                                                                 \
    inline constexpr size_t kFirstSize<Struct> =                                                \
        offsetof(Struct, first) + sizeof(static_cast<Struct*>(nullptr)->first);                 \
    static_assert(                                                                              \
        sizeof(Struct) == offsetof(Struct, last) + sizeof(static_cast<Struct*>(nullptr)->last), \
        #Struct " does not end with " #last)

FBRDF_FIRST_SIZE(fbrdf_table, storage, reserved);
FBRDF_FIRST_SIZE(fbrdf_material_desc, name, name);
FBRDF_FIRST_SIZE(fbrdf_renderer_desc, no_debug_labels, passes);
FBRDF_FIRST_SIZE(fbrdf_gpu_material_desc, map_size, precise);
FBRDF_FIRST_SIZE(fbrdf_mesh_desc, indices, reserved);
FBRDF_FIRST_SIZE(fbrdf_buffer_array, stride, stride);
FBRDF_FIRST_SIZE(fbrdf_mesh_buffers_desc, tangent_components, tangent_components);
FBRDF_FIRST_SIZE(fbrdf_hooks_desc, reach, reserved);
FBRDF_FIRST_SIZE(fbrdf_light, outer_angle, outer_angle);
FBRDF_FIRST_SIZE(fbrdf_item, model, reserved);
FBRDF_FIRST_SIZE(fbrdf_depth_desc, clear, clear);
FBRDF_FIRST_SIZE(fbrdf_area_light, vertices, vertices);
FBRDF_FIRST_SIZE(fbrdf_draw_desc, max_lookups, reserved);
FBRDF_FIRST_SIZE(fbrdf_draw_stats, passes, error_filtering_absolute);
FBRDF_FIRST_SIZE(fbrdf_environment_desc, unfiltered, reserved);
FBRDF_FIRST_SIZE(fbrdf_environment_light, intensity, reserved);
FBRDF_FIRST_SIZE(fbrdf_instance, material, material);
FBRDF_FIRST_SIZE(fbrdf_batch_desc, instances, hooks);
FBRDF_FIRST_SIZE(fbrdf_glsl_desc, max_lights, sampling);

#undef FBRDF_FIRST_SIZE

}  // namespace fbrdf::capi

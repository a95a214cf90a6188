/* fbrdf_batch.h - many materials: objects with different BRDFs in one draw call. */
#ifndef FBRDF_BATCH_H
#define FBRDF_BATCH_H
#include <fbrdf/fbrdf_draw.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fbrdf_library fbrdf_library;

/* Packs the maps of count BRDFs that differ in numbers only into texture arrays (OpenGL 3.1); the
 * others have textures of their own. The BRDFs are copied. */
FBRDF_API fbrdf_result fbrdf_library_create(fbrdf_renderer* renderer, uint32_t count,
                                            const fbrdf_brdf* const* brdfs, fbrdf_library** out);
/* Another BRDF, of whatever layout, in the place of one; on failure it keeps that one. */
FBRDF_API fbrdf_result fbrdf_library_replace(fbrdf_library* library, uint32_t index,
                                             const fbrdf_brdf* brdf);
/* The same from a file, for a host that saw it change: a file that is missing, broken or only half
 * written changes nothing, and the next call may try again. */
FBRDF_API fbrdf_result fbrdf_library_load(fbrdf_library* library, uint32_t index, const char* path);
/* Why materials are drawn one by one; "" where all are packed. Lives as long as the library; empty
 * for NULL. */
FBRDF_API const char* fbrdf_library_why_apart(const fbrdf_library* library);
FBRDF_API void fbrdf_library_release(fbrdf_library* library);

typedef struct fbrdf_instance {
    float model[16];   /* affine */
    uint32_t material; /* index into the library */
} fbrdf_instance;

typedef struct fbrdf_batch_desc {
    uint32_t struct_size;
    uint32_t instance_count, instance_size; /* instance_size: sizeof(fbrdf_instance) */
    const fbrdf_library* library;
    const fbrdf_mesh* mesh;
    const fbrdf_instance* instances;
    const fbrdf_hooks* hooks; /* as of fbrdf_item; may read gl_InstanceID */
    uint32_t normal_map;
} fbrdf_batch_desc;

/* One mesh many times: one draw call a pass for all instances whose materials share a layout.
 * draw: as of fbrdf_draw, without items. */
FBRDF_API fbrdf_result fbrdf_draw_batch(fbrdf_renderer* renderer, const fbrdf_draw_desc* draw,
                                        const fbrdf_batch_desc* batch, fbrdf_draw_stats* stats);

#ifdef __cplusplus
}
#endif
#endif

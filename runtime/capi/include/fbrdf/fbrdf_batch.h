/* fbrdf_batch.h - objects with different materials in one draw call. Conventions: fbrdf.h. */
#ifndef FBRDF_BATCH_H
#define FBRDF_BATCH_H
#include <fbrdf/fbrdf_draw.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The GPU side of many materials. An object of its renderer: same context, one thread at a time.
 * Lives until it is released; draws name it, and it must live until they return. */
typedef struct fbrdf_library fbrdf_library;

/* Packs the maps of `count` materials that differ in numbers only into texture arrays (OpenGL 3.1);
 * the others have textures of their own. */
FBRDF_API fbrdf_result fbrdf_library_create(fbrdf_renderer* renderer, uint32_t count,
                                            const fbrdf_material* const* materials,
                                            fbrdf_library** out);
/* The same, uploaded as desc says, but that recombined maps are not packed; NULL: native look-ups.
 */
FBRDF_API fbrdf_result fbrdf_library_create_with(fbrdf_renderer* renderer, uint32_t count,
                                                 const fbrdf_material* const* materials,
                                                 const fbrdf_gpu_material_desc* desc,
                                                 fbrdf_library** out);
/* Puts another material, of whatever layout, in the place of one; on failure the library keeps the
 * one that it has. */
FBRDF_API fbrdf_result fbrdf_library_replace(fbrdf_library* library, uint32_t index,
                                             const fbrdf_material* material);
/* Why materials are drawn one by one; "" where all are packed. The text lives until a material is
 * replaced or the library is released. "" for NULL. */
FBRDF_API const char* fbrdf_library_why_not_packed(const fbrdf_library* library);
FBRDF_API void fbrdf_library_release(fbrdf_library* library);

typedef struct fbrdf_instance {
    float model[16];   /* affine */
    uint32_t material; /* index into the library */
} fbrdf_instance;

typedef struct fbrdf_batch_desc {
    uint32_t struct_size;
    uint32_t instance_count;
    uint32_t instance_size; /* sizeof(fbrdf_instance) */
    uint32_t normal_map;    /* as in fbrdf_item */
    const fbrdf_library* library;
    const fbrdf_mesh* mesh;
    const fbrdf_instance* instances;
    const fbrdf_hooks* hooks; /* as in fbrdf_item; the vertex hook may read gl_InstanceID */
} fbrdf_batch_desc;

/* Draws one mesh many times, with one draw call a pass for all instances whose materials share a
 * layout. `draw` is as for fbrdf_draw, without items. stats may be NULL. */
FBRDF_API fbrdf_result fbrdf_draw_batch(fbrdf_renderer* renderer, const fbrdf_draw_desc* draw,
                                        const fbrdf_batch_desc* batch, fbrdf_draw_stats* stats);

#ifdef __cplusplus
}
#endif
#endif

/* fbrdf_draw.h - renderers, what they draw, and drawing. Conventions: fbrdf.h. */
#ifndef FBRDF_DRAW_H
#define FBRDF_DRAW_H
#include <fbrdf/fbrdf_core.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fbrdf_renderer fbrdf_renderer;
typedef struct fbrdf_material fbrdf_material;
typedef struct fbrdf_mesh fbrdf_mesh;

/* May return NULL for what does not exist. */
typedef void* (*fbrdf_load_function)(void* user, const char* name);
typedef enum fbrdf_state_mode {
    FBRDF_STATE_RESTORE = 0,
    FBRDF_STATE_DEFAULTS = 1,
    FBRDF_STATE_LEAVE = 2
} fbrdf_state_mode;

typedef struct fbrdf_renderer_desc {
    uint32_t struct_size;
    uint32_t api_version; /* FBRDF_API_VERSION; another major is refused */
    fbrdf_load_function load;
    void* load_user;
    fbrdf_log log;
    uint32_t state_mode;         /* fbrdf_state_mode */
    uint32_t first_texture_unit; /* units from here on are used */
    uint32_t no_debug_labels;    /* 1: no KHR_debug names and groups */
} fbrdf_renderer_desc;

FBRDF_API fbrdf_result fbrdf_renderer_create(const fbrdf_renderer_desc* desc, fbrdf_renderer** out);
/* The context is gone: nothing of this renderer touches GL any more. */
FBRDF_API void fbrdf_renderer_abandon(fbrdf_renderer* renderer);
/* Materials, meshes and bindings may be released before or after. NULL does nothing. */
FBRDF_API void fbrdf_renderer_release(fbrdf_renderer* renderer);

FBRDF_API fbrdf_result fbrdf_material_create(fbrdf_renderer* renderer, const fbrdf_brdf* brdf,
                                             fbrdf_material** out);
typedef enum fbrdf_look_up {
    FBRDF_LOOK_UP_NATIVE = 0,    /* warped as the BRDF says */
    FBRDF_LOOK_UP_PARABOLIC = 1, /* at (x, y) / (1 + z) */
    FBRDF_LOOK_UP_CUBE = 2       /* at (x, y, z), in cube maps */
} fbrdf_look_up;
typedef struct fbrdf_material_desc {
    uint32_t struct_size;
    uint32_t look_up;  /* fbrdf_look_up, of the maps over one direction; others stay native */
    uint32_t map_size; /* texels on a side, even, 2 to 2048; 0: as many as it needs, see
                          fbrdf/brdf/DirectionMap.h */
} fbrdf_material_desc;
/* The same with its maps recombined; a BRDF that comes in its place has them so too. */
FBRDF_API fbrdf_result fbrdf_material_create_as(fbrdf_renderer* renderer, const fbrdf_brdf* brdf,
                                                const fbrdf_material_desc* desc,
                                                fbrdf_material** out);
/* Why maps stayed native; "" where none did. Until the BRDF is replaced. "" for NULL. */
FBRDF_API const char* fbrdf_material_why_native(const fbrdf_material* material);
/* How far recombined maps may be from those of the BRDF, |log2| of a product; draws count it in
 * their error. 0 for NULL. */
FBRDF_API float fbrdf_material_look_up_error(const fbrdf_material* material);

/* Another BRDF in the place of the one it has; on failure it keeps that one. */
FBRDF_API fbrdf_result fbrdf_material_replace(fbrdf_material* material, const fbrdf_brdf* brdf);
/* The same from a file, for a host that saw it change. */
FBRDF_API fbrdf_result fbrdf_material_load(fbrdf_material* material, const char* path);
FBRDF_API void fbrdf_material_release(fbrdf_material* material);

typedef struct fbrdf_mesh_desc {
    uint32_t struct_size;
    uint32_t vertex_count, index_count; /* three indices a triangle, counter-clockwise outside */
    const float* positions;             /* vertex_count x 3 */
    const float* normals;               /* vertex_count x 3 */
    const float* tangents;              /* vertex_count x 3, or NULL */
    const uint32_t* indices;
    const float* handedness; /* of tangents, vertex_count, negative where s = -n x t; or NULL: 1 */
    const float* texture_coordinates; /* vertex_count x 2, or NULL */
    uint32_t extra_count;             /* at most 4 */
    const float* const* extra;        /* extra_count arrays of vertex_count x 4, for vertex hooks */
} fbrdf_mesh_desc;
FBRDF_API fbrdf_result fbrdf_mesh_create(fbrdf_renderer* renderer, const fbrdf_mesh_desc* desc,
                                         fbrdf_mesh** out);
FBRDF_API void fbrdf_mesh_release(fbrdf_mesh* mesh);

typedef struct fbrdf_hooks fbrdf_hooks;

/* GLSL of the host in the programs of its objects: gl/Renderer.h, Hooks. */
typedef struct fbrdf_hooks_desc {
    uint32_t struct_size;
    /* void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent): moves a
     * vertex, object space; may declare FBRDF_ATTRIBUTE vec4 fbrdfExtra0 to 3. NULL: none */
    const char* vertex;
    float reach; /* distance that it moves a vertex at most; 0: not known, no light is culled */
    /* float fbrdfShadow(int light, vec3 position, vec3 toLight): what passes of a light, by its
     * place in the draw's array; eye space. NULL: none */
    const char* shadow;
    uint32_t shadow_uniforms; /* vec4 uniforms that `shadow` declares */
    /* Sets the host's uniforms, with the program current; may be NULL. Draws call it, so user must
     * outlive the hooks. */
    void (*set_uniforms)(void* user, uint32_t program);
    void* user;
} fbrdf_hooks_desc;
/* FBRDF_ERROR_INPUT with the compiler's words for what does not compile. Texts are copied. */
FBRDF_API fbrdf_result fbrdf_hooks_create(fbrdf_renderer* renderer, const fbrdf_hooks_desc* desc,
                                          fbrdf_hooks** out);
FBRDF_API void fbrdf_hooks_release(fbrdf_hooks* hooks);

typedef enum fbrdf_light_type {
    FBRDF_POINT = 0,
    FBRDF_DIRECTIONAL = 1,
    FBRDF_SPOT = 2
} fbrdf_light_type;
typedef struct fbrdf_light {
    float position[3]; /* world; of a directional light the vector towards it */
    float radius;      /* of influence; 0: unlimited */
    float intensity[3];
    uint32_t type;                  /* fbrdf_light_type */
    float axis[3];                  /* of a spot */
    float inner_angle, outer_angle; /* of a spot, radians from the axis */
} fbrdf_light;

typedef struct fbrdf_item {
    const fbrdf_material* material;
    const fbrdf_mesh* mesh;
    float model[16];
    const fbrdf_hooks* hooks; /* or NULL */
    uint32_t normal_map;      /* a 2D texture of the host, 2 texel - 1 in the tangent frame; or 0 */
} fbrdf_item;

typedef enum fbrdf_technique {
    FBRDF_SINGLE = 0,
    FBRDF_BATCHED = 1,
    FBRDF_TWO_LOOKUP = 2
} fbrdf_technique;
typedef enum fbrdf_transfer {
    FBRDF_LINEAR = 0,
    FBRDF_EXPOSURE = 1,
    FBRDF_SRGB = 2,
    FBRDF_TONE_MAP = 3
} fbrdf_transfer;

typedef struct fbrdf_draw_desc {
    uint32_t struct_size;
    uint32_t framebuffer; /* 0: the window's */
    int32_t width, height;
    uint32_t transfer; /* fbrdf_transfer */
    float exposure;    /* 0: 1 */
    float view[16], projection[16];
    uint32_t item_count, item_size; /* item_size: sizeof(fbrdf_item) */
    const fbrdf_item* items;
    uint32_t light_count, light_size; /* light_size: sizeof(fbrdf_light) */
    const fbrdf_light* lights;
    uint32_t technique;       /* fbrdf_technique */
    uint32_t lights_per_pass; /* FBRDF_BATCHED; 0: 8 */
    uint32_t max_lookups;     /* in any pass; 0: what the technique says */
    uint32_t max_lights;      /* of one item, the strongest; 0: no limit */
    uint32_t clustered;       /* 1: lists of lights for each part of the view */
} fbrdf_draw_desc;

typedef struct fbrdf_draw_stats {
    uint32_t struct_size; /* set by the caller */
    uint32_t passes, draw_calls, items_failed;
    uint32_t lights_given, lights_used, lights_dropped;
    uint32_t max_lookups;
    char accumulation[16];  /* "RGBA32F", ... */
    uint32_t lights_culled; /* do not reach an item, summed over items */
    uint32_t technique;     /* fbrdf_technique of the item that needed most passes */
    /* |stored - exact| <= error_relative max(|exact|, mean / 100) + error_absolute, Plan.h */
    float error_relative, error_absolute;
    char why_replaced[160]; /* why another technique than asked for was taken; "": it was not */
} fbrdf_draw_stats;

/* stats may be NULL. FBRDF_OK although items were left out: they are counted and logged. */
FBRDF_API fbrdf_result fbrdf_draw(fbrdf_renderer* renderer, const fbrdf_draw_desc* desc,
                                  fbrdf_draw_stats* stats);

#ifdef __cplusplus
}
#endif
#endif

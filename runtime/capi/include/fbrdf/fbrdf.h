/* fbrdf.h - the runtime for programs in C, and for engines that load it: one stable ABI.
 *
 * Conventions
 *   - Every descriptor begins with struct_size = sizeof it, as the caller compiled it. Fields that
 * an older caller does not have take their defaults; a newer caller's extra bytes must be 0, else
 *     FBRDF_ERROR_VERSION. Zero is the default of every field that has one.
 *   - Functions that can fail return fbrdf_result and leave *out NULL; the log says what was found
 *     and what was expected. Nothing throws, prints, exits or keeps global state.
 *   - fbrdf_brdf is immutable: share it between threads and contexts. All that takes a renderer, a
 *     material, a mesh or a binding needs the GL context of that renderer current, destructors
 *     included, and one thread at a time. Renderers are independent of each other.
 *   - Vectors are float[3]; matrices float[16], columns one after the other, as OpenGL's.
 *   - What the numbers mean: fbrdf/plan/Light.h and Transfer.h, fbrdf/brdf/Conventions.h; which GL
 *     state is touched: runtime/gl/README.md.
 * A C++ wrapper that releases by itself: fbrdf.hpp. */
#ifndef FBRDF_FBRDF_H
#define FBRDF_FBRDF_H
#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define FBRDF_API __declspec(dllexport)
#else
#define FBRDF_API __attribute__((visibility("default")))
#endif
#ifdef __cplusplus
extern "C" {
#endif

#define FBRDF_VERSION(major, minor) (major##u * 0x10000u + minor##u)
#define FBRDF_API_VERSION FBRDF_VERSION(0, 1)
/* Of the library that is loaded. Another major: do not call it. A minor at least the one compiled
 * against: everything used is there. */
FBRDF_API uint32_t fbrdf_api_version(void);

typedef enum fbrdf_result {
    FBRDF_OK = 0,
    FBRDF_ERROR_VERSION = 1,  /* a struct_size that is too small, or bytes that are not known */
    FBRDF_ERROR_ARGUMENT = 2, /* NULL where something is needed, a number out of range */
    FBRDF_ERROR_INPUT = 3,    /* a file or data that is missing, unreadable or invalid */
    FBRDF_ERROR_GL = 4,       /* what the context cannot do, or refused */
    FBRDF_ERROR_MEMORY = 5,   /* out of memory on the CPU */
    FBRDF_ERROR_INTERNAL = 6  /* a fault of the library */
} fbrdf_result;
/* Static text, never NULL. */
FBRDF_API const char* fbrdf_result_text(fbrdf_result result);

typedef enum fbrdf_severity { FBRDF_NOTE = 0, FBRDF_WARNING = 1, FBRDF_ERROR = 2 } fbrdf_severity;
/* code: the result that the call will return, or FBRDF_OK for what a draw survives. text is only
 * valid during the call. Called on the thread that called the library. */
typedef void (*fbrdf_log_function)(void* user, fbrdf_severity severity, fbrdf_result code,
                                   const char* text);
typedef struct fbrdf_log {
    fbrdf_log_function function; /* may be NULL */
    void* user;
} fbrdf_log;

/* ---- BRDFs: data, no GL ---- */
typedef struct fbrdf_brdf fbrdf_brdf;

typedef enum fbrdf_form {
    FBRDF_PQP = 0,  /* p(wo) q(h) p(wi); size {n}: two tables of n x n texels */
    FBRDF_PQPR = 1, /* and r(theta_d); size {n, knots}: a third of knots texels */
    FBRDF_HDIO = 2  /* T1(theta_h, theta_d) T2(theta_i, theta_o); size {h, d, io} */
} fbrdf_form;

typedef struct fbrdf_brdf_desc {
    uint32_t struct_size;
    uint32_t form;   /* fbrdf_form */
    int32_t size[3]; /* texels, see fbrdf_form */
    float gamma;     /* of the disc maps (Projection.h); 0: 0.5 */
    float scale[3];  /* RGB; 0 0 0: 1 1 1 */
    uint32_t table_count;
    /* table_count arrays of texels x 3 floats, log2 F, RGB contiguous, then x, then y. Copied. */
    const float* const* tables;
    const char* name; /* may be NULL */
} fbrdf_brdf_desc;

FBRDF_API fbrdf_result fbrdf_brdf_create(const fbrdf_brdf_desc* desc, const fbrdf_log* log,
                                         fbrdf_brdf** out);
/* .fbrdf, the 2001 layout, PNG + JSON: every form that a file can hold. log may be NULL. */
FBRDF_API fbrdf_result fbrdf_brdf_load(const char* path, const fbrdf_log* log, fbrdf_brdf** out);
/* f(wo, wi) in 1/sr as the shader computes it; unit directions in the tangent frame, z the normal;
 * 0 at or below the horizon. */
FBRDF_API fbrdf_result fbrdf_brdf_evaluate(const fbrdf_brdf* brdf, const float wo[3],
                                           const float wi[3], float rgb[3]);
FBRDF_API void fbrdf_brdf_release(fbrdf_brdf* brdf); /* NULL does nothing */

/* ---- drawing ---- */
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
} fbrdf_mesh_desc;
FBRDF_API fbrdf_result fbrdf_mesh_create(fbrdf_renderer* renderer, const fbrdf_mesh_desc* desc,
                                         fbrdf_mesh** out);
FBRDF_API void fbrdf_mesh_release(fbrdf_mesh* mesh);

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
    /* |stored - exact| <= error_relative max(|exact|, mean / 1000) + error_absolute, Plan.h */
    float error_relative, error_absolute;
    char why_replaced[160]; /* why another technique than asked for was taken; "": it was not */
} fbrdf_draw_stats;

/* stats may be NULL. FBRDF_OK although items were left out: they are counted and logged. */
FBRDF_API fbrdf_result fbrdf_draw(fbrdf_renderer* renderer, const fbrdf_draw_desc* desc,
                                  fbrdf_draw_stats* stats);

/* ---- many materials: objects with different BRDFs in one draw call ---- */
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
} fbrdf_batch_desc;

/* One mesh many times: one draw call a pass for all instances whose materials share a layout.
 * draw: as of fbrdf_draw, without items. */
FBRDF_API fbrdf_result fbrdf_draw_batch(fbrdf_renderer* renderer, const fbrdf_draw_desc* draw,
                                        const fbrdf_batch_desc* batch, fbrdf_draw_stats* stats);

/* ---- for engines that draw by themselves ---- */
typedef enum fbrdf_snippet {
    FBRDF_GLSL_ANGLES = 0,     /* angles of a pair */
    FBRDF_GLSL_PROJECTION = 1, /* positions in tables */
    FBRDF_GLSL_FRAME = 2,      /* the tangent frame */
    FBRDF_GLSL_LIGHTS = 3,     /* irradiance and direction of a light */
    FBRDF_GLSL_TRANSFER = 4    /* sRGB and tone mapping */
} fbrdf_snippet;
/* Static text that needs nothing else, the same as the installed file; NULL for another number. */
FBRDF_API const char* fbrdf_glsl_snippet(uint32_t snippet);

typedef struct fbrdf_glsl_desc {
    uint32_t struct_size;
    uint32_t glsl_version; /* 120, 140, 150, 330, 450; ES: 100, 300; 0: 330 */
    uint32_t max_lights;   /* room of the uniform array fbrdfLights; 0: 8 */
} fbrdf_glsl_desc;
/* The functions of one material, to be put after the engine's #version line and before its main():
 *   vec3 fbrdfEvaluate(vec3 wo, vec3 wi)      f in 1/sr; unit, tangent frame, above the horizon
 *   vec3 fbrdfRadiance(vec3 position, vec3 normal, vec3 tangent, vec3 viewer)
 *                                             sum over fbrdfLightCount lights of f cos E; all in
 * the space of the lights, viewer unit, towards the eye Snippets included. *text lives as long as
 * the material. */
FBRDF_API fbrdf_result fbrdf_material_glsl(fbrdf_material* material, const fbrdf_glsl_desc* desc,
                                           const char** text);

typedef struct fbrdf_binding fbrdf_binding;
/* The places of the material in a linked program that contains its functions. */
FBRDF_API fbrdf_result fbrdf_binding_create(fbrdf_material* material, uint32_t program,
                                            fbrdf_binding** out);
/* Makes the program current, sets its uniforms and binds the textures from `unit` on, samplers
 * unbound there; units_used may be NULL. The only call that changes state for good. */
FBRDF_API fbrdf_result fbrdf_binding_apply(fbrdf_binding* binding, uint32_t unit,
                                           uint32_t* units_used);
FBRDF_API void fbrdf_binding_release(fbrdf_binding* binding);

/* A light as fbrdfLights takes it: three vec4 in the space that `to_space` (NULL: identity) leads
 * to. */
FBRDF_API fbrdf_result fbrdf_light_vectors(const fbrdf_light* light, const float to_space[16],
                                           float vectors[12]);

#ifdef __cplusplus
}
#endif
#endif

/* fbrdf_draw.h - lights, objects, and drawing them. Conventions: fbrdf.h. */
#ifndef FBRDF_DRAW_H
#define FBRDF_DRAW_H
#include <fbrdf/fbrdf_environment.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum fbrdf_light_type {
    FBRDF_LIGHT_POINT = 0,
    FBRDF_LIGHT_DIRECTIONAL = 1,
    FBRDF_LIGHT_SPOT = 2
} fbrdf_light_type;
/* A light that is not valid (fbrdf/plan/Light.h) is dropped and counted. */
typedef struct fbrdf_light {
    float position[3]; /* in the world; of a directional light the vector towards it */
    float radius;      /* no influence beyond it; 0: unlimited */
    float intensity[3];
    uint32_t type;                  /* fbrdf_light_type */
    float axis[3];                  /* of a spot: where it shines */
    float inner_angle, outer_angle; /* of a spot, radians from the axis */
} fbrdf_light;

typedef enum fbrdf_area_shape {
    FBRDF_AREA_SHAPE_SPHERE = 0,
    FBRDF_AREA_SHAPE_DISC = 1,
    FBRDF_AREA_SHAPE_RECTANGLE = 2,
    FBRDF_AREA_SHAPE_TUBE = 3, /* ends in half spheres */
    FBRDF_AREA_SHAPE_POLYGON = 4
} fbrdf_area_shape;
/* A light with a shape, which materials reflect by their lobes (as an environment); fields of other
 * shapes are not read. One that is not valid (fbrdf/plan/AreaLight.h) is dropped, counted and
 * logged. */
typedef struct fbrdf_area_light {
    float position[3]; /* in the world: the centre, or one end of a tube */
    float size;        /* radius of a sphere, disc or tube */
    float radiance[3]; /* W/(sr m^2) */
    float radius;      /* no influence beyond it from the centre; 0: unlimited */
    float end[3];      /* the other end of a tube */
    uint32_t shape;    /* fbrdf_area_shape */
    float normal[3];   /* of a disc */
    uint32_t two_sided;
    float axis_u[3], axis_v[3]; /* half sides of a rectangle, which shines along axis_u x axis_v */
    uint32_t vertex_count;      /* of a polygon, 3 to 256 */
    uint32_t reserved;          /* 0 */
    const float* vertices;      /* x, y, z of each, counterclockwise seen from where it shines */
} fbrdf_area_light;

/* One object of a draw. */
typedef struct fbrdf_item {
    const fbrdf_gpu_material* material;
    const fbrdf_mesh* mesh;
    float model[16];          /* invertible; may scale unevenly and mirror */
    const fbrdf_hooks* hooks; /* or NULL */
    uint32_t normal_map;      /* 2D texture of the host or 0: 2 texel - 1 in the tangent frame */
    uint32_t reserved;        /* 0 */
} fbrdf_item;

typedef enum fbrdf_technique {
    FBRDF_TECHNIQUE_SINGLE = 0,    /* all lights in one pass */
    FBRDF_TECHNIQUE_BATCHED = 1,   /* lights_per_pass lights in a pass */
    FBRDF_TECHNIQUE_TWO_LOOKUP = 2 /* one light a pass, at most two look-ups in it */
} fbrdf_technique;
/* What the framebuffer receives of the radiance: fbrdf/plan/Transfer.h. A window shows sRGB. */
typedef enum fbrdf_transfer {
    FBRDF_TRANSFER_LINEAR = 0, /* the radiance itself */
    FBRDF_TRANSFER_EXPOSURE = 1,
    FBRDF_TRANSFER_SRGB = 2,
    FBRDF_TRANSFER_TONE_MAP = 3
} fbrdf_transfer;

/* Who makes lists of lights; in statistics AUTOMATIC: there were none. The CPU takes over where the
 * GPU cannot, and the picture is the same. */
typedef enum fbrdf_lists_by {
    FBRDF_LISTS_BY_AUTOMATIC = 0, /* a GPU with OpenGL 4.3, else the CPU */
    FBRDF_LISTS_BY_CPU = 1,
    FBRDF_LISTS_BY_GPU = 2
} fbrdf_lists_by;

/* The format of the surfaces in which lights add up, where they cannot in the target. One that the
 * context does not have, or whose error would be no picture, is replaced by what AUTOMATIC takes:
 * the smallest one whose error is below half a step of the target (fbrdf/plan/Plan.h). */
typedef enum fbrdf_accumulation {
    FBRDF_ACCUMULATION_AUTOMATIC = 0,
    FBRDF_ACCUMULATION_RGBA8 = 1,
    FBRDF_ACCUMULATION_RGBA16 = 2,
    FBRDF_ACCUMULATION_RGBA16F = 3,
    FBRDF_ACCUMULATION_RGBA32F = 4
} fbrdf_accumulation;

/* What mixes the texels of a look-up: see `precise` of fbrdf_gpu_material_desc. */
typedef enum fbrdf_filter { FBRDF_FILTER_HARDWARE = 0, FBRDF_FILTER_SHADER = 1 } fbrdf_filter;

/* A fragment passes where its depth compares so with the depth that is stored. */
typedef enum fbrdf_depth_test {
    FBRDF_DEPTH_TEST_LESS = 0,
    FBRDF_DEPTH_TEST_LESS_EQUAL = 1,
    FBRDF_DEPTH_TEST_GREATER = 2,
    FBRDF_DEPTH_TEST_GREATER_EQUAL = 3
} fbrdf_depth_test;
/* The depths that the projection leaves in clip space, divided by w. */
typedef enum fbrdf_clip_depth {
    FBRDF_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE = 0, /* OpenGL's own */
    FBRDF_CLIP_DEPTH_ZERO_TO_ONE = 1          /* needs OpenGL 4.5 or ARB_clip_control */
} fbrdf_clip_depth;
/* How the host's depth buffer works; no field has a default. A new context has {LESS,
 * NEGATIVE_ONE_TO_ONE, 0, 1, 1}; reversed depth is {GREATER, ZERO_TO_ONE, 0, 1, 0}. */
typedef struct fbrdf_depth_desc {
    uint32_t struct_size;
    uint32_t test;               /* fbrdf_depth_test */
    uint32_t clip;               /* fbrdf_clip_depth */
    float range_low, range_high; /* as glDepthRange takes them: in [0, 1], in either order */
    float clear;                 /* what an empty depth buffer contains, in [0, 1] */
} fbrdf_depth_desc;

typedef struct fbrdf_draw_desc {
    uint32_t struct_size;
    uint32_t framebuffer;  /* 0: the window's */
    int32_t width, height; /* pixels; the viewport is all of them */
    uint32_t transfer;     /* fbrdf_transfer */
    float exposure;        /* not of FBRDF_TRANSFER_LINEAR; 0: 1 */
    float view[16];        /* rigid; the camera looks along -z */
    float projection[16];  /* perspective or orthographic */
    uint32_t item_count;   /* 0: nothing is drawn */
    uint32_t item_size;    /* sizeof(fbrdf_item) */
    const fbrdf_item* items;
    uint32_t light_count;
    uint32_t light_size; /* sizeof(fbrdf_light) */
    const fbrdf_light* lights;
    uint32_t technique;       /* fbrdf_technique */
    uint32_t lights_per_pass; /* of FBRDF_TECHNIQUE_BATCHED; 0: 8 */
    uint32_t max_lookups;     /* texture look-ups in any pass; 0: what the technique says */
    uint32_t max_lights;      /* the strongest lights of an item, or part of the view; 0: all */
    uint32_t clustered;       /* 1: lists of the lights that reach each part of the view */
    uint32_t lists_by;        /* fbrdf_lists_by */
    const fbrdf_depth_desc* depth;              /* NULL: as in a new context */
    const fbrdf_environment_light* environment; /* NULL: none */
    const fbrdf_area_light* area_lights;
    uint32_t area_light_count;
    uint32_t area_light_size; /* sizeof(fbrdf_area_light) */
    uint32_t accumulation;    /* fbrdf_accumulation */
    uint32_t reserved;        /* 0 */
} fbrdf_draw_desc;

typedef struct fbrdf_draw_stats {
    uint32_t struct_size;  /* set by the caller; fields that the library does not know become 0 */
    uint32_t passes;       /* of the item that needed most */
    uint32_t draw_calls;   /* of all items */
    uint32_t items_failed; /* not drawn; the log received why */
    uint32_t lights_given, lights_used; /* area lights included */
    uint32_t lights_dropped;            /* not valid, or above max_lights */
    uint32_t max_lookups;   /* look-ups of a fragment in any pass, counted from the programs */
    char accumulation[16];  /* format of the surface in which lights add up: "RGBA32F", ... */
    uint32_t lights_culled; /* lights that do not reach an item, summed over items */
    uint32_t technique;     /* fbrdf_technique of the item that needed most passes */
    /* |stored - exact| <= error_relative max(|exact|, mean / 100) + error_absolute, see
     * fbrdf/plan/Plan.h. */
    float error_relative, error_absolute;
    char why_replaced[160]; /* why another technique than asked for was taken; "": it was not */
    uint32_t items_without_environment; /* drawn without it or area lights; the log received why */
    float environment_error; /* expected error of its light, relative: of the material where it is
                                largest */
    char why_no_environment[160]; /* why the last of those items was drawn without; "" */
    char why_not_sampled[160];    /* why lobes were drawn instead of the environment's `samples` */
    uint32_t lists_by;            /* fbrdf_lists_by */
    char why_lists_by_cpu[160];   /* why the CPU made lists of lights; "": it did not */
    char why_accumulation[160];   /* why `accumulation` was taken; "": there was no choice */
    uint32_t filter;              /* fbrdf_filter of the maps of the item that `technique` is of */
    /* What is included in the errors above: how far recombined maps, and the context's filter, may
     * move a product of logarithmic maps, |log2|, and what the filter may add through others. */
    float error_recombination, error_filtering, error_filtering_absolute;
} fbrdf_draw_stats;

/* Draws the items into the framebuffer, in front of what its depth buffer contains. stats may be
 * NULL. The result is FBRDF_RESULT_OK although items were left out: they are counted and logged. */
FBRDF_API fbrdf_result fbrdf_draw(fbrdf_renderer* renderer, const fbrdf_draw_desc* desc,
                                  fbrdf_draw_stats* stats);

/* Builds the programs that drawing the items with these options and so many lights will need, and
 * so keeps the first draw from waiting for a compiler; draws nothing. The framebuffer, its size and
 * the matrices are not read: the programs are those of an RGBA32F target. With an environment it
 * waits for the lobes of materials that have none. An item without a material or mesh is
 * FBRDF_RESULT_ERROR_ARGUMENT. */
FBRDF_API fbrdf_result fbrdf_prepare(fbrdf_renderer* renderer, const fbrdf_draw_desc* desc);

#ifdef __cplusplus
}
#endif
#endif

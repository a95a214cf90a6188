/* fbrdf_renderer.h - renderers and what they keep on the GPU: materials, meshes, hooks.
 * Conventions: fbrdf.h, which also states lifetimes and threads for all of them. */
#ifndef FBRDF_RENDERER_H
#define FBRDF_RENDERER_H
#include <fbrdf/fbrdf_material.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Belongs to the context that is current at fbrdf_renderer_create: current again whenever it, or
 * one of its objects, is used or released. One thread at a time. */
typedef struct fbrdf_renderer fbrdf_renderer;

/* Looks a GL function up by name, as glfwGetProcAddress and its kin do; may return NULL for what
 * does not exist. Called during fbrdf_renderer_create only. */
typedef void* (*fbrdf_load_function)(void* user, const char* name);
/* What becomes of the GL state that calls touch. */
typedef enum fbrdf_state_mode {
    FBRDF_STATE_RESTORE = 0,  /* put back; costs a query for each state and call */
    FBRDF_STATE_DEFAULTS = 1, /* left as in a new context, but for the viewport; no queries */
    FBRDF_STATE_LEAVE = 2     /* left as the draw needed it; no queries */
} fbrdf_state_mode;

/* A pass of an item, or of the objects of a batch that are drawn together. */
typedef struct fbrdf_pass_event {
    uint32_t struct_size; /* as the library was compiled: it has no fields beyond */
    uint32_t index;       /* of the `count` passes of the item */
    uint32_t count;
    uint32_t lookups;     /* texture look-ups of a fragment, counted from the program */
    uint32_t first_light; /* lights of the item that the pass adds up; of lists of lights one */
    uint32_t light_count;
    const char* material; /* its name, which lives until the function returns */
} fbrdf_pass_event;
typedef void (*fbrdf_pass_function)(void* user, const fbrdf_pass_event* event);
/* Told of each pass of a draw, while its state is set: a host may begin and end queries, and
 * touches no other state. They must not call the library; either may be NULL. */
typedef struct fbrdf_pass_watch {
    fbrdf_pass_function begins, ends;
    void* user; /* passed to both; must live as long as the renderer */
} fbrdf_pass_watch;

typedef struct fbrdf_renderer_desc {
    uint32_t struct_size;
    uint32_t api_version; /* FBRDF_API_VERSION, as the program was compiled */
    fbrdf_load_function load;
    void* load_user;
    fbrdf_log log;               /* may be called until the last object of the renderer is gone */
    uint32_t state_mode;         /* fbrdf_state_mode */
    uint32_t first_texture_unit; /* units from here on are used */
    uint32_t no_debug_labels;    /* 1: no KHR_debug names and groups */
    uint32_t idle_programs;      /* so many that the last 256 draws did not need are kept; 0: 256 */
    fbrdf_pass_watch passes;
} fbrdf_renderer_desc;

FBRDF_API fbrdf_result fbrdf_renderer_create(const fbrdf_renderer_desc* desc, fbrdf_renderer** out);
/* For a context that is gone: nothing of this renderer touches GL any more, and its calls fail. */
FBRDF_API void fbrdf_renderer_abandon(fbrdf_renderer* renderer);
/* Its objects may be released before or after. NULL does nothing. */
FBRDF_API void fbrdf_renderer_release(fbrdf_renderer* renderer);

/* The textures and programs of one material. Lives until it is released; draws name it, and it must
 * live until they return. A binding keeps what it needs of it. */
typedef struct fbrdf_gpu_material fbrdf_gpu_material;

typedef enum fbrdf_look_up {
    FBRDF_LOOK_UP_NATIVE = 0,    /* as the domains of the form demand */
    FBRDF_LOOK_UP_PARABOLIC = 1, /* at (x, y) / (1 + z) */
    FBRDF_LOOK_UP_CUBE = 2       /* at (x, y, z), in cube maps */
} fbrdf_look_up;
/* How a material is uploaded; materials that replace it are uploaded in the same way. */
typedef struct fbrdf_gpu_material_desc {
    uint32_t struct_size;
    uint32_t look_up;  /* fbrdf_look_up of the maps over one direction; other maps stay native */
    uint32_t map_size; /* texels on a side of those maps, even, 2 to 2048; 0: as many as needed,
                          see fbrdf/brdf/DirectionMap.h */
    uint32_t precise;  /* not 0: filtered in the shader, see fbrdf/gl/MaterialOptions.h */
} fbrdf_gpu_material_desc;

/* Uploads a material and builds its first program, so that a material that the context cannot draw
 * is refused here. desc may be NULL: native look-ups. */
FBRDF_API fbrdf_result fbrdf_gpu_material_create(fbrdf_renderer* renderer,
                                                 const fbrdf_material* material,
                                                 const fbrdf_gpu_material_desc* desc,
                                                 fbrdf_gpu_material** out);
/* Draws with another material from now on; on failure it keeps the one that it has. */
FBRDF_API fbrdf_result fbrdf_gpu_material_replace(fbrdf_gpu_material* gpu_material,
                                                  const fbrdf_material* material);
/* Why maps stayed native although the descriptor asked for others; "" where none did. The text
 * lives until the material is replaced or released. "" for NULL. */
FBRDF_API const char* fbrdf_gpu_material_why_not_recombined(const fbrdf_gpu_material* gpu_material);
/* How far a product of recombined maps may be from that of the tables, |log2|; draws include it in
 * their error. 0 for NULL. */
FBRDF_API float fbrdf_gpu_material_look_up_error(const fbrdf_gpu_material* gpu_material);
/* How far it may be because the context filters textures coarsely, |log2|, as measured; 0 where the
 * shader filters, and for NULL. */
FBRDF_API float fbrdf_gpu_material_filter_error(const fbrdf_gpu_material* gpu_material);
FBRDF_API void fbrdf_gpu_material_release(fbrdf_gpu_material* gpu_material);

/* The triangles of one object: buffers of its own, or those of the host. Lives until it is
 * released; draws name it, and it must live until they return. */
typedef struct fbrdf_mesh fbrdf_mesh;

/* Triangles in object space. Arrays are copied. */
typedef struct fbrdf_mesh_desc {
    uint32_t struct_size;
    uint32_t vertex_count;
    uint32_t index_count;    /* three a triangle, counter-clockwise seen from outside */
    const float* positions;  /* vertex_count x 3 */
    const float* normals;    /* vertex_count x 3, need not be unit, must not be 0 */
    const float* tangents;   /* vertex_count x 3, or NULL */
    const uint32_t* indices; /* index_count */
    const float* handedness; /* vertex_count, of tangents: negative where s = -n x t; or NULL: 1 */
    const float* texture_coordinates; /* vertex_count x 2, or NULL */
    const float* const* extra;        /* extra_count arrays of vertex_count x 4, for vertex hooks */
    uint32_t extra_count;             /* at most 4 */
    uint32_t reserved;                /* 0 */
} fbrdf_mesh_desc;
FBRDF_API fbrdf_result fbrdf_mesh_create(fbrdf_renderer* renderer, const fbrdf_mesh_desc* desc,
                                         fbrdf_mesh** out);

/* 32-bit floats in a buffer object of the host, one element for each vertex. */
typedef struct fbrdf_buffer_array {
    uint64_t offset; /* bytes before the first element */
    uint32_t buffer; /* the buffer object; 0: the mesh has no such array */
    uint32_t stride; /* bytes from one element to the next; 0: they follow each other */
} fbrdf_buffer_array;
typedef enum fbrdf_index_type { FBRDF_INDEX_UINT32 = 0, FBRDF_INDEX_UINT16 = 1 } fbrdf_index_type;
/* Buffer objects of the host, bound where they are. Nothing is copied: what the host writes into
 * them later is drawn, and the mesh must not be drawn after the host has deleted one of them. */
typedef struct fbrdf_mesh_buffers_desc {
    uint32_t struct_size;
    uint32_t vertex_count;                  /* indices are below it */
    fbrdf_buffer_array positions, normals;  /* three floats each */
    fbrdf_buffer_array tangents;            /* tangent_components floats each; may be missing */
    fbrdf_buffer_array texture_coordinates; /* two floats each; may be missing */
    fbrdf_buffer_array extra[4];            /* four floats each, for vertex hooks; may be missing */
    uint64_t index_offset;                  /* bytes before the first index */
    /* Centre x, y, z and radius of a sphere around all positions, before vertex hooks move them:
     * lights are culled by it, so it must stay true when positions change. NULL: the positions are
     * read back once, which waits for the GPU; OpenGL ES cannot, and needs it. */
    const float* bounds;
    uint32_t index_buffer;
    uint32_t index_count;        /* three a triangle, counter-clockwise seen from outside */
    uint32_t index_type;         /* fbrdf_index_type */
    uint32_t tangent_components; /* 4: the last is the handedness, as in glTF; 3: none; 0: 4 */
} fbrdf_mesh_buffers_desc;
FBRDF_API fbrdf_result fbrdf_mesh_create_from_buffers(fbrdf_renderer* renderer,
                                                      const fbrdf_mesh_buffers_desc* desc,
                                                      fbrdf_mesh** out);
FBRDF_API void fbrdf_mesh_release(fbrdf_mesh* mesh);

/* GLSL of the host in the programs of its objects. Lives until it is released; draws name it, and
 * it and the `user` of its descriptor must live until they return. */
typedef struct fbrdf_hooks fbrdf_hooks;

/* fbrdf/gl/Renderer.h, Hooks, states what the functions may use. */
typedef struct fbrdf_hooks_desc {
    uint32_t struct_size;
    uint32_t shadow_uniforms; /* vec4 uniforms that `shadow` declares */
    /* void fbrdfVertexHook(inout vec3 position, inout vec3 normal, inout vec4 tangent) moves a
     * vertex in object space; may declare FBRDF_ATTRIBUTE vec4 fbrdfExtra0 to 3. NULL: none */
    const char* vertex;
    /* float fbrdfShadow(int light, vec3 position, vec3 toLight) returns what passes of a light, by
     * its place in the draw's array; eye space. NULL: none */
    const char* shadow;
    /* Sets the host's uniforms, with the program current, during draws; may be NULL. */
    void (*set_uniforms)(void* user, uint32_t program);
    void* user;
    float reach; /* the most that `vertex` moves a vertex; 0: not known, so no light is culled */
    uint32_t reserved; /* 0 */
} fbrdf_hooks_desc;
/* FBRDF_RESULT_ERROR_INPUT for what does not compile; the log receives the compiler's words. Texts
 * are copied. */
FBRDF_API fbrdf_result fbrdf_hooks_create(fbrdf_renderer* renderer, const fbrdf_hooks_desc* desc,
                                          fbrdf_hooks** out);
FBRDF_API void fbrdf_hooks_release(fbrdf_hooks* hooks);

#ifdef __cplusplus
}
#endif
#endif

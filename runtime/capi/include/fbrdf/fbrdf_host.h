/* fbrdf_host.h - for engines that draw by themselves. Conventions: fbrdf.h. */
#ifndef FBRDF_HOST_H
#define FBRDF_HOST_H
#include <fbrdf/fbrdf_draw.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum fbrdf_snippet {
    FBRDF_SNIPPET_ANGLES = 0,     /* angles of a pair of directions */
    FBRDF_SNIPPET_PROJECTION = 1, /* positions in tables */
    FBRDF_SNIPPET_FRAME = 2,      /* the tangent frame */
    FBRDF_SNIPPET_LIGHTS = 3,     /* irradiance and direction of a light */
    FBRDF_SNIPPET_TRANSFER = 4    /* sRGB and tone mapping */
} fbrdf_snippet;
/* Static text that needs nothing else, the same as the installed file in share/fbrdf/glsl; NULL for
 * another number. */
FBRDF_API const char* fbrdf_glsl_snippet(uint32_t snippet);

typedef struct fbrdf_glsl_desc {
    uint32_t struct_size;
    uint32_t glsl_version; /* 120, 140, 150, 330, 450; ES: 100, 300; 0: 330 */
    uint32_t max_lights;   /* room of the uniform array fbrdfLights; 0: 8 */
    uint32_t sampling;     /* 1: with the functions that draw directions */
} fbrdf_glsl_desc;
/* The functions of one material, to be put after the engine's #version line and before its main():
 *   vec3 fbrdfEvaluate(vec3 wo, vec3 wi)
 *       f in 1/sr, 0 at or below the horizon; unit directions in the tangent frame
 *   vec3 fbrdfRadiance(vec3 position, vec3 normal, vec4 tangent, vec3 viewer)
 *       the sum over fbrdfLightCount lights of f times irradiance; all in the space of the lights;
 *       viewer is unit, towards the eye; tangent.w is the handedness as in glTF, 1 where tangent is
 *       a vec3
 *   uniform vec4 fbrdfLights[3 * max_lights];  uniform int fbrdfLightCount;
 *       what the engine sets, see fbrdf_light_vectors
 * and where `sampling` is 1, from GLSL 1.20 and ES 3.00 on, with lobes that are fitted where the
 * material has none:
 *   vec4 fbrdfSampleLobes(vec3 wo, vec2 u)
 *       a direction wi in proportion to what is reflected, and its density in 1/sr; u in [0, 1);
 *       wi may be below the horizon, where f is 0
 *   float fbrdfLobePdf(vec3 wo, vec3 wi)
 *       that density of any direction
 * The snippets are included. *text lives until the material is replaced or
 * released. */
FBRDF_API fbrdf_result fbrdf_gpu_material_glsl(fbrdf_gpu_material* gpu_material,
                                               const fbrdf_glsl_desc* desc, const char** text);

/* The uniforms and samplers of a material in one program of the host. An object of the renderer:
 * same context, one thread at a time. It keeps what it needs of the material that the GPU material
 * had when it was made, so make another one after a replacement. */
typedef struct fbrdf_binding fbrdf_binding;
/* `program` is linked and contains the functions of this material; it must outlive the binding. */
FBRDF_API fbrdf_result fbrdf_binding_create(fbrdf_gpu_material* gpu_material, uint32_t program,
                                            fbrdf_binding** out);
/* Makes the program current, sets its uniforms and binds the textures from `unit` on, with samplers
 * unbound there; units_used may be NULL. This is the only call that changes GL state for good. */
FBRDF_API fbrdf_result fbrdf_binding_apply(fbrdf_binding* binding, uint32_t unit,
                                           uint32_t* units_used);
FBRDF_API void fbrdf_binding_release(fbrdf_binding* binding);

/* A light as fbrdfLights takes it: three vec4 in the space that `to_space` leads to from the
 * light's own; NULL is the identity. Needs no context. */
FBRDF_API fbrdf_result fbrdf_light_vectors(const fbrdf_light* light, const float to_space[16],
                                           float vectors[12]);

#ifdef __cplusplus
}
#endif
#endif

/* fbrdf_host.h - for engines that draw by themselves. */
#ifndef FBRDF_HOST_H
#define FBRDF_HOST_H
#include <fbrdf/fbrdf_draw.h>

#ifdef __cplusplus
extern "C" {
#endif

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
 *   vec3 fbrdfRadiance(vec3 position, vec3 normal, vec4 tangent, vec3 viewer)
 *       sum over fbrdfLightCount lights of f cos E; all in the space of the lights; viewer unit,
 *       towards the eye; tangent.w: handedness (glTF), 1 where tangent is a vec3
 * Snippets included. *text lives as long as
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

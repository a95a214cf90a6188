/* fbrdf_environment.h - light from everywhere. Conventions: fbrdf.h. */
#ifndef FBRDF_ENVIRONMENT_H
#define FBRDF_ENVIRONMENT_H
#include <fbrdf/fbrdf_renderer.h>

#ifdef __cplusplus
extern "C" {
#endif

/* An environment, prefiltered once for all materials. Lives until it is released; draws name it,
 * and it must live until they return. */
typedef struct fbrdf_environment fbrdf_environment;

/* Radiance, linear Rec. 709. Row 0 is at +y; the middle column is at -z, and +x is to the right of
 * it. */
typedef struct fbrdf_environment_desc {
    uint32_t struct_size;
    uint32_t width, height; /* texels of `radiance` */
    uint32_t texture;       /* 0, or a texture of the host instead of `radiance`: 2D in the same
                               layout, row 0 uploaded first, or a cube map */
    const float* radiance;  /* height x width x 3, finite and >= 0; or NULL */
    uint32_t cube;          /* 1: `texture` is a cube map */
    uint32_t size;          /* texels on a side of a face, a power of two from 8 on; 0: 512, or 256
                               where a CPU samples textures */
    uint32_t floats;        /* 1: RGBA32F instead of RGBA16F, which ends at 65504 */
    uint32_t unfiltered;    /* 1: keeps what fbrdf_environment_light::samples needs: RGBA32F */
    uint32_t gradual;       /* 1: leaves levels of more than 32 texels on a side to
                               fbrdf_environment_refine; it can be drawn with at once. Without effect
                               where a CPU makes the environment */
    uint32_t reserved;      /* 0 */
} fbrdf_environment_desc;
FBRDF_API fbrdf_result fbrdf_environment_create(fbrdf_renderer* renderer,
                                                const fbrdf_environment_desc* desc,
                                                fbrdf_environment** out);
/* Draws about `texels` (at least 1) texels more of an environment that comes gradually, its
 * sharpest lobes last: all of one with faces of N texels are 8 N^2, and each costs hundreds of
 * look-ups. *finished, which may be NULL, becomes 1 where nothing is left, else 0. */
FBRDF_API fbrdf_result fbrdf_environment_refine(fbrdf_environment* environment, uint32_t texels,
                                                uint32_t* finished);
FBRDF_API void fbrdf_environment_release(fbrdf_environment* environment);

/* How a draw is lit by an environment; changing it costs nothing. */
typedef struct fbrdf_environment_light {
    uint32_t struct_size;
    uint32_t lobes; /* 1 to 3: so many tilted lobes at most, or 1, 3 or all bent ones; 0: all */
    const fbrdf_environment* environment;
    float rotation;     /* radians about +y of the world, counter-clockwise seen from above */
    float intensity[3]; /* times the radiance; finite, >= 0 */
    uint32_t samples;   /* 0: lobes; else directions that are drawn by them, at most 4096, for each
                           of which the material and the environment are looked up. Needs
                           `unfiltered` and FBRDF_TECHNIQUE_SINGLE without max_lookups, see
                           why_not_sampled */
    uint32_t reserved;  /* 0 */
} fbrdf_environment_light;

#ifdef __cplusplus
}
#endif
#endif

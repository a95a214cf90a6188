/* fbrdf_material.h - materials: measured BRDFs as data, without GL. Conventions: fbrdf.h. */
#ifndef FBRDF_MATERIAL_H
#define FBRDF_MATERIAL_H
#include <fbrdf/fbrdf_core.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Immutable: threads, renderers and contexts may share it, also while others are made from it. It
 * lives until fbrdf_material_release; nothing that was made from it needs it any more. */
typedef struct fbrdf_material fbrdf_material;

typedef enum fbrdf_storage {
    FBRDF_STORAGE_FLOAT = 0,   /* log2 F as 32-bit floats */
    FBRDF_STORAGE_HALF = 1,    /* log2 F as 16-bit floats */
    FBRDF_STORAGE_LOG8 = 2,    /* log2 F in 8 bits: differences between neighbours */
    FBRDF_STORAGE_LINEAR8 = 3, /* F in [0, 1] in 8 bits */
    FBRDF_STORAGE_SIGNED = 4   /* F of either sign as 16-bit floats */
} fbrdf_storage;

/* One table of a form. */
typedef struct fbrdf_table {
    /* texel_count x channels: log2 F, or F where the storage is linear or signed; the channels of a
     * texel first, then texels along the first axis, the second, the third. */
    const float* texels;
    uint32_t texel_count; /* as many as the form's domain has: size x size of a disc, the product
                             of the sizes of a grid's axes */
    uint32_t channels;    /* 3, or 1 for a shape shared by R, G, B; 0: 3 */
    uint32_t storage;     /* fbrdf_storage: texels are rounded to it */
    uint32_t reserved;    /* 0 */
} fbrdf_table;

typedef struct fbrdf_material_desc {
    uint32_t struct_size;
    uint32_t table_count; /* as many as the form has, in its order */
    uint32_t table_size;  /* sizeof(fbrdf_table) */
    uint32_t scale_count; /* the number of the form's terms; 0: every scale is 1 */
    /* JSON text, as under "form" in a material's manifest: fbrdf/io/FormFile.h describes it, and
     * `fbrdf convert gold.fbrdf gold.json` writes the form of a material. */
    const char* form;
    const fbrdf_table* tables;
    const float* scales; /* scale_count x RGB, >= 0 */
    const char* name;    /* may be NULL */
} fbrdf_material_desc;

/* A material of any form from numbers in memory. log may be NULL. */
FBRDF_API fbrdf_result fbrdf_material_create(const fbrdf_material_desc* desc, const fbrdf_log* log,
                                             fbrdf_material** out);
/* Reads a .fbrdf, a 2001 layout, or PNG + JSON, recognised by content. log may be NULL. A file that
 * is only half written is FBRDF_RESULT_ERROR_INPUT, so a host may try again. */
FBRDF_API fbrdf_result fbrdf_material_read(const char* path, const fbrdf_log* log,
                                           fbrdf_material** out);
/* The material of a whole .fbrdf in memory, as from inside a host's archive. `where` stands for a
 * path in the log. log may be NULL. */
FBRDF_API fbrdf_result fbrdf_material_read_bytes(const void* bytes, size_t size, const char* where,
                                                 const fbrdf_log* log, fbrdf_material** out);
/* f(wo, wi) in 1/sr as the shader computes it, 0 at or below the horizon. Directions are unit
 * vectors in the tangent frame, with z along the normal. */
FBRDF_API fbrdf_result fbrdf_material_evaluate(const fbrdf_material* material, const float wo[3],
                                               const float wi[3], float rgb[3]);
FBRDF_API void fbrdf_material_release(fbrdf_material* material); /* NULL does nothing */

#ifdef __cplusplus
}
#endif
#endif

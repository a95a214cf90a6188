/* fbrdf_core.h - version, results, log, and BRDFs: data, no GL. Conventions: fbrdf.h. */
#ifndef FBRDF_CORE_H
#define FBRDF_CORE_H
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

#ifdef __cplusplus
}
#endif
#endif

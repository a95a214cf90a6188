/* fbrdf_core.h - version, results and log. Conventions: fbrdf.h. */
#ifndef FBRDF_CORE_H
#define FBRDF_CORE_H
#include <stddef.h>
#include <stdint.h>

/* FBRDF_BUILDING is defined while the library itself is compiled. */
#if defined(_WIN32) && defined(FBRDF_BUILDING)
#define FBRDF_API __declspec(dllexport)
#elif defined(_WIN32)
#define FBRDF_API __declspec(dllimport)
#else
#define FBRDF_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define FBRDF_VERSION(major, minor) (major##u * 0x10000u + minor##u)
#define FBRDF_API_VERSION FBRDF_VERSION(0, 2)
/* Programs compiled against an older version use names that are gone. */
#define FBRDF_API_OLDEST_VERSION FBRDF_VERSION(0, 2)
/* The FBRDF_API_VERSION of the library that is loaded. A program finds everything that it uses
 * where this is at least the version that it was compiled against and the major is the same. */
FBRDF_API uint32_t fbrdf_api_version(void);

typedef enum fbrdf_result {
    FBRDF_RESULT_OK = 0,
    FBRDF_RESULT_ERROR_VERSION = 1,  /* a size that is too small, or bytes that are not known */
    FBRDF_RESULT_ERROR_ARGUMENT = 2, /* NULL where something is needed, a number out of range */
    FBRDF_RESULT_ERROR_INPUT = 3,    /* a file or data that is missing, unreadable or invalid */
    FBRDF_RESULT_ERROR_GL = 4,       /* the context cannot do it, or refused */
    FBRDF_RESULT_ERROR_MEMORY = 5,   /* out of memory on the CPU */
    FBRDF_RESULT_ERROR_INTERNAL = 6  /* a fault of the library */
} fbrdf_result;
/* Static text, never NULL. */
FBRDF_API const char* fbrdf_result_text(fbrdf_result result);

typedef enum fbrdf_severity {
    FBRDF_SEVERITY_NOTE = 0,
    FBRDF_SEVERITY_WARNING = 1,
    FBRDF_SEVERITY_ERROR = 2
} fbrdf_severity;
/* code is the result that the call is about to return, or FBRDF_RESULT_OK for what a draw survives.
 * text lives until the function returns. It runs on the thread that called the library, and must
 * not call the library. */
typedef void (*fbrdf_log_function)(void* user, fbrdf_severity severity, fbrdf_result code,
                                   const char* text);
typedef struct fbrdf_log {
    fbrdf_log_function function; /* may be NULL */
    void* user;                  /* passed to function; must live as long as what was given it */
} fbrdf_log;

#ifdef __cplusplus
}
#endif
#endif

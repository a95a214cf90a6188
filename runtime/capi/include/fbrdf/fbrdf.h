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
#include <fbrdf/fbrdf_batch.h>
#include <fbrdf/fbrdf_core.h>
#include <fbrdf/fbrdf_draw.h>
#include <fbrdf/fbrdf_host.h>
#endif

/* plain.h - a host in C11: makes a material from numbers, draws a quad, and returns what it got. */
#ifndef FBRDF_TESTS_PLAIN_H
#define FBRDF_TESTS_PLAIN_H
#include <fbrdf/fbrdf.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Everything a host needs: renderer, material, mesh, one draw with one directional light into a
 * framebuffer of size x size. The first result that is not FBRDF_RESULT_OK. */
fbrdf_result plain_draw(fbrdf_load_function load, void* user, fbrdf_log log, uint32_t framebuffer,
                        int32_t size, fbrdf_draw_stats* stats);

/* The same for a depth buffer of the host's; depth may be NULL. */
fbrdf_result plain_draw_with_depth(fbrdf_load_function load, void* user, fbrdf_log log,
                                   uint32_t framebuffer, int32_t size,
                                   const fbrdf_depth_desc* depth, fbrdf_draw_stats* stats);

/* One draw of a mesh with one directional light along -z; depth and stats may be NULL. */
fbrdf_result plain_draw_mesh(fbrdf_renderer* renderer, const fbrdf_gpu_material* material,
                             const fbrdf_mesh* mesh, uint32_t framebuffer, int32_t size,
                             const fbrdf_depth_desc* depth, fbrdf_draw_stats* stats);

/* The material of plain_draw: an hdio whose tables are constant, so that f = 1/4 R, 1/2 G, 1 B. */
fbrdf_result plain_material(const fbrdf_log* log, fbrdf_material** out);

#ifdef __cplusplus
}
#endif
#endif

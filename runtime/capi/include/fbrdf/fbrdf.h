/* fbrdf.h - the runtime for programs in C, and for engines that load it: one stable ABI.
 *
 * Words
 *   - A material (fbrdf_material) is data: a form, its tables, its scales. It knows no GL.
 *   - A GPU material (fbrdf_gpu_material) is the object of a renderer that draws with a material:
 *     its textures and programs.
 *   - To read is to make a material from a file; to replace is to give a GPU object another
 *     material, with which it draws from then on.
 *
 * Conventions
 *   - Every descriptor begins with struct_size = sizeof it, as the caller compiled it; arrays of
 *     structs come with the size of an element. Fields that an older caller does not have take
 *     their defaults; fields that the library does not know must be 0, else the result is
 *     FBRDF_RESULT_ERROR_VERSION. Zero is the default of every field that has one.
 *   - Functions that can fail return fbrdf_result and leave *out NULL; the log receives a line with
 *     what was found and what was expected. Nothing throws, prints, exits or keeps global state.
 *   - Arrays and texts that a function is given are read before it returns and not kept. Texts that
 *     a function gives belong to the library; the function's comment states how long they live.
 *   - Vectors are float[3]; matrices float[16], one column after the other, as in OpenGL.
 *   - fbrdf/plan/Light.h, fbrdf/plan/Transfer.h and fbrdf/brdf/Conventions.h define what the
 *     numbers mean; fbrdf/gl/Renderer.h lists the GL state that is touched.
 *
 * Lifetimes and threads
 *   - A material never changes: any number of threads, renderers and contexts may share it. What is
 *     made from it copies what it needs, so a material may be released at once.
 *   - A renderer belongs to the GL context that was current when it was made. Functions that take a
 *     renderer, or one of its GPU materials, meshes, hooks, libraries or bindings, need that
 * context current on the calling thread and one thread at a time; releasing is one of them.
 * Renderers do not share anything, so each may have a thread of its own.
 *   - The objects of a renderer may be released before it or after it, in any order. What a draw
 *     names must live until that draw returns, no longer.
 *
 * Versions: a library runs programs compiled against FBRDF_API_OLDEST_VERSION or later, up to its
 * own. fbrdf_renderer_create checks that. fbrdf.hpp has C++ handles that release by themselves. */
#ifndef FBRDF_FBRDF_H
#define FBRDF_FBRDF_H
#include <fbrdf/fbrdf_batch.h>
#include <fbrdf/fbrdf_core.h>
#include <fbrdf/fbrdf_draw.h>
#include <fbrdf/fbrdf_environment.h>
#include <fbrdf/fbrdf_host.h>
#include <fbrdf/fbrdf_material.h>
#include <fbrdf/fbrdf_renderer.h>
#endif

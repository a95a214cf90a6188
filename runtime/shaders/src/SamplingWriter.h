// SamplingWriter.h - writes what draws directions by the lobes of a material, and the program that
// looks an environment up in directions drawn so.
#pragma once
#include "FragmentWriter.h"

namespace fbrdf {

/// Numbers and uniforms of a table, and the functions of lobe_frame.glsl, lobes.glsl and
/// sampling.glsl.
std::string lobeFunctions(const LobeLayout& table);

/// The main function of a pass that draws directions (LobeShare::samples). Expects context.local
/// and fbrdfEvaluate.
std::string sampledMain(const FragmentContext& context);

}  // namespace fbrdf

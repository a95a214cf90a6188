// Figures.h - the figures of Romanyuk et al. 2020, made anew, with what they are compared with:
//
//   figure-1a           the true BRDF of an anisotropic satin (Poulin and Fournier 1990) at the
//                       vertices of a knot, interpolated between them
//   figure-1b           its factorization p(wo) q(half) p(wi)
//   figure-1-reference  the true BRDF at every pixel, in double
//   figure-2            six materials in one scene under eight lights, factored
//   figure-2-reference  the same by the true BRDFs
//   ...-error           for each picture, how far it is from its reference: the largest difference
//                       of the three channels as they are shown (sRGB, white is 1), by colours
//   figures.json        the numbers
#pragma once
#include "Options.h"

namespace fbrdf::viewer {

/// Writes them to the folder options.out, which is made where it is missing, each of options.width
/// squared pixels. All appear together or none does. Throws Error(output), and what drawing throws.
void writeFigures(const Options& options);

}  // namespace fbrdf::viewer

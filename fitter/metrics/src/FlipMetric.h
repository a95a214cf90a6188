// FlipMetric.h - FLIP, the difference that a viewer sees when two pictures alternate in place.
// Reference: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild 2020, "FLIP: A
// Difference Evaluator for Alternating Images", sections 4 and 5 (LDR pictures). Written from the
// paper.
#pragma once
#include "Plane.h"

#include <array>

namespace fbrdf {

/// R, G, B planes of linear Rec. 709 in [0, 1], all of one size.
using RgbPlanes = std::array<Plane, 3>;

/// 0.7 m from a 3840 pixel, 0.7 m wide monitor: the observer that the paper gives its figures for.
constexpr double kFlipPixelsPerDegree = 67.0;

/// FLIP in [0, 1] at every pixel. Symmetric in its arguments.
Plane flipMap(const RgbPlanes& image, const RgbPlanes& reference,
              double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace fbrdf

// SubPixels.h - where the samples of a pixel are: every renderer takes the same places, so that
// pictures of the same number of samples show the same edges.
#pragma once
#include <fbrdf/gl/Draw.h>

namespace fbrdf::scene {

/// Where sample i of every pixel is, from its centre, in pixels: (-0.5, 0.5)^2. Sample 0 is the
/// centre; any number of samples is spread evenly.
Vec2<double> subPixel(int i);

/// The view that sees in the middle of each pixel what `view` sees at that place of it.
gl::View movedBy(gl::View view, const Vec2<double>& place, int width, int height);

}  // namespace fbrdf::scene

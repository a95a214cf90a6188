// Headless.h - a picture drawn by the runtime without a display.
#pragma once
#include "World.h"

namespace fbrdf::viewer {

/// Draws options.frames frames into an RGBA32F framebuffer and returns the last one. Throws
/// Error(gl) where there is no usable GL.
Picture drawHeadless(const Options& options, World& world);

/// Fills the fields that a draw of the runtime reports.
void addDrawStats(const gl::DrawStats& drawn, const gl::Renderer& renderer, scene::Stats& stats);

/// Makes a picture of rows that begin at the bottom, as GL reads them.
scene::Image imageFromBottomRows(const std::vector<float>& rgba, int width, int height);

/// Counts the pixels with coverage.
int coveredPixels(const scene::Image& image);

}  // namespace fbrdf::viewer

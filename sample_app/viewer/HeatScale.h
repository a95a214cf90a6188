// HeatScale.h - differences of pictures as colours, with the scale of what they mean.
#pragma once
#include <fbrdf/brdf/Conventions.h>
#include <fbrdf/scene/Image.h>

namespace fbrdf::viewer {

/// What the brightest colour stands for: differences of at least a tenth of white.
constexpr float kHottest = 0.1f;

/// Its colours, linear, in even steps.
constexpr Vec3f kHeatStops[] = {{0.0f, 0.0f, 0.0f},
                                {0.08f, 0.01f, 0.25f},
                                {0.5f, 0.02f, 0.1f},
                                {0.9f, 0.35f, 0.01f},
                                {1.0f, 1.0f, 0.8f}};
constexpr int kHeatStopCount = 5;

/// Linear RGB of a share of kHottest in [0, 1], from black over violet, red and yellow to white:
/// lightness rises evenly.
Vec3f heatColour(float share);

/// The largest difference of the three channels of the sRGB codes that are shown at an exposure, as
/// colours, with the scale in the lower left corner of pictures that have room for it. Both have
/// one size. See scene::srgbCodes.
scene::Image heatMap(const scene::Image& image, const scene::Image& reference, float exposure,
                     Transfer transfer = Transfer::srgb);
/// The same of codes, height x width x 3.
scene::Image heatMap(int width, int height, const std::vector<uint8_t>& image,
                     const std::vector<uint8_t>& reference);

}  // namespace fbrdf::viewer

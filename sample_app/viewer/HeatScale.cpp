#include "HeatScale.h"

#include "LabelFont.h"

#include <fbrdf/plan/Transfer.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::viewer {
namespace {

constexpr Vec3f kStops[] = {{0.0f, 0.0f, 0.0f},
                            {0.08f, 0.01f, 0.25f},
                            {0.5f, 0.02f, 0.1f},
                            {0.9f, 0.35f, 0.01f},
                            {1.0f, 1.0f, 0.8f}};
constexpr int kBarWidth = 128, kBarHeight = 8, kMargin = 8;

/// As the window and files have it.
float shown(float radiance, float exposure)
{
    return static_cast<float>(scene::srgbCode(exposure * radiance)) / 255.0f;
}

void setPixel(scene::Image& image, int x, int y, const Vec3f& colour)
{
    float* const pixel = image.pixel(x, y);
    for (int c = 0; c < 3; ++c) pixel[c] = colour[c];
    pixel[3] = 1.0f;
}

void drawScale(scene::Image& image)
{
    if (image.width < 2 * kBarWidth || image.height < 8 * kBarHeight) return;
    const LabelFont font(1);
    const int top = image.height - kMargin - font.height() - kBarHeight;
    for (int x = 0; x < kBarWidth; ++x)
        for (int y = 0; y < kBarHeight; ++y)
            setPixel(image, kMargin + x, top + y,
                     heatColour((static_cast<float>(x) + 0.5f) / kBarWidth));
    font.draw(image, {kMargin, top + kBarHeight, kBarWidth}, "0", 1.0f);
    const std::string most = "10 % of white";
    font.draw(image, {kMargin + kBarWidth - font.widthOf(most), top + kBarHeight, kBarWidth}, most,
              1.0f);
}

}  // namespace

Vec3f heatColour(float share)
{
    constexpr int kSteps = static_cast<int>(std::size(kStops)) - 1;
    const float place = std::clamp(share, 0.0f, 1.0f) * kSteps;
    const int step = std::min(static_cast<int>(place), kSteps - 1);
    return glm::mix(kStops[step], kStops[step + 1], place - static_cast<float>(step));
}

scene::Image heatMap(const scene::Image& image, const scene::Image& reference, float exposure)
{
    scene::Image map(image.width, image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            float largest = 0.0f;
            for (int c = 0; c < 3; ++c)
                largest = std::max(largest, std::abs(shown(image.pixel(x, y)[c], exposure) -
                                                     shown(reference.pixel(x, y)[c], exposure)));
            setPixel(map, x, y, heatColour(largest / kHottest));
        }
    drawScale(map);
    return map;
}

}  // namespace fbrdf::viewer

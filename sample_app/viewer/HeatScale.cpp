#include "HeatScale.h"

#include "LabelFont.h"

#include <algorithm>
#include <cstdlib>

namespace fbrdf::viewer {
namespace {

constexpr int kBarWidth = 128, kBarHeight = 8, kMargin = 8;

void setPixel(scene::Image& image, int x, int y, const Vec3f& colour)
{
    float* const pixel = image.pixel(x, y);
    for (int c = 0; c < 3; ++c) pixel[c] = colour[c];
    pixel[3] = 1.0f;
}

void drawScale(scene::Image& image)
{
    if (!LabelFont::isThere() || image.width < 2 * kBarWidth || image.height < 8 * kBarHeight)
        return;
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
    constexpr int kSteps = kHeatStopCount - 1;
    const float place = std::clamp(share, 0.0f, 1.0f) * kSteps;
    const int step = std::min(static_cast<int>(place), kSteps - 1);
    return glm::mix(kHeatStops[step], kHeatStops[step + 1], place - static_cast<float>(step));
}

scene::Image heatMap(const scene::Image& image, const scene::Image& reference, float exposure,
                     Transfer transfer)
{
    return heatMap(image.width, image.height, srgbCodes(image, exposure, transfer),
                   srgbCodes(reference, exposure, transfer));
}

scene::Image heatMap(int width, int height, const std::vector<uint8_t>& image,
                     const std::vector<uint8_t>& reference)
{
    scene::Image map(width, height);
    size_t i = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x, i += 3) {
            int largest = 0;
            for (size_t c = 0; c < 3; ++c)
                largest = std::max(largest, std::abs(image[i + c] - reference[i + c]));
            setPixel(map, x, y, heatColour(static_cast<float>(largest) / 255.0f / kHottest));
        }
    drawScale(map);
    return map;
}

}  // namespace fbrdf::viewer

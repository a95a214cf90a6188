#include "ComparePicture.h"

#include "HeatScale.h"
#include "LabelFont.h"

#include <fbrdf/base/Srgb.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fbrdf::viewer {
namespace {

using scene::CompareMode;
using Codes = std::vector<uint8_t>;

constexpr int kLeastLabelled = 256;  // pixels of a side, for labels to leave something to see
constexpr int kLabelMargin = 8, kPixelsPerLetterScale = 640;
constexpr float kInkShown = 0.9f, kBehindLabel = 0.25f;

float linearOfCode(int code)
{
    static const std::array<float, 256> values = [] {
        std::array<float, 256> all{};
        for (size_t i = 0; i < all.size(); ++i)
            all[i] = static_cast<float>(linearFromSrgb(static_cast<double>(i) / 255.0));
        return all;
    }();
    return values[static_cast<size_t>(std::clamp(code, 0, 255))];
}

/// A picture of codes that `code(pixel, channel)` gives.
template <class CodeOf>
scene::Image ofCodes(int width, int height, const CodeOf& codeOf)
{
    scene::Image image(width, height);
    for (size_t i = 0; i < image.pixelCount(); ++i) {
        for (size_t c = 0; c < 3; ++c) image.rgba[4 * i + c] = linearOfCode(codeOf(i, c));
        image.rgba[4 * i + 3] = 1.0f;
    }
    return image;
}

bool hasRoom(const scene::Image& image)
{
    return LabelFont::isThere() && image.width >= kLeastLabelled && image.height >= kLeastLabelled;
}

void darken(scene::Image& image, int left, int top, int width, int height)
{
    for (int y = std::max(0, top); y < std::min(image.height, top + height); ++y)
        for (int x = std::max(0, left); x < std::min(image.width, left + width); ++x)
            for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] *= kBehindLabel;
}

enum class Corner { topLeft, topRight, bottomRight };

/// A label in a corner of the columns [left, left + width).
void drawCaption(scene::Image& image, int left, int width, Corner corner, const std::string& text)
{
    const LabelFont font(std::max(1, width / kPixelsPerLetterScale));
    const int room = width - 4 * kLabelMargin;
    if (room < 4 * kLabelMargin) return;
    const int length = std::min(font.widthOf(text), room);
    const int x = corner != Corner::topLeft ? left + width - 2 * kLabelMargin - length
                                            : left + 2 * kLabelMargin;
    const int height = font.height() + kLabelMargin;
    const int top =
        corner == Corner::bottomRight ? image.height - kLabelMargin - height : kLabelMargin;
    darken(image, x - kLabelMargin, top, length + 2 * kLabelMargin, height);
    font.draw(image, {x, top + kLabelMargin / 2, length}, text, kInkShown);
}

scene::Image split(const ComparePair& pair, const Codes& a, const Codes& b, float at)
{
    const int width = pair.a.width, line = lineColumn(width, at);
    scene::Image image = ofCodes(width, pair.a.height, [&](size_t i, size_t c) {
        return (static_cast<int>(i % static_cast<size_t>(width)) < line ? a : b)[3 * i + c];
    });
    if (!hasRoom(image)) return image;
    for (int y = 0; line > 0 && line < width && y < image.height; ++y)
        std::fill_n(image.pixel(line, y), 3, 1.0f);
    drawCaption(image, 0, line, Corner::topLeft, "A: " + pair.titleA);
    drawCaption(image, line, width - line, Corner::topRight, "B: " + pair.titleB);
    return image;
}

scene::Image whole(const ComparePair& pair, const Codes& codes, bool isB)
{
    scene::Image image =
        ofCodes(pair.a.width, pair.a.height, [&](size_t i, size_t c) { return codes[3 * i + c]; });
    if (hasRoom(image))
        drawCaption(image, 0, image.width, isB ? Corner::topRight : Corner::topLeft,
                    isB ? "B: " + pair.titleB : "A: " + pair.titleA);
    return image;
}

std::string differenceLabel(const ComparePair& pair)
{
    return fmt::format("|{} - {}|", pair.titleA, pair.titleB);
}

scene::Image difference(const ComparePair& pair, const Codes& a, const Codes& b, float gain)
{
    scene::Image image = ofCodes(pair.a.width, pair.a.height, [&](size_t i, size_t c) {
        const auto off = static_cast<float>(std::abs(a[3 * i + c] - b[3 * i + c]));
        return static_cast<int>(std::lround(std::min(255.0f, gain * off)));
    });
    if (hasRoom(image))
        drawCaption(image, 0, image.width, Corner::topLeft,
                    fmt::format("{} x {:g}", differenceLabel(pair), gain));
    return image;
}

scene::Image heat(const ComparePair& pair, const Codes& a, const Codes& b)
{
    scene::Image image = heatMap(pair.a.width, pair.a.height, a, b);
    if (hasRoom(image)) drawCaption(image, 0, image.width, Corner::topLeft, differenceLabel(pair));
    return image;
}

scene::Image laidOver(const ComparePair& pair, const CompareLayout& layout)
{
    const auto [exposure, transfer] = pair.exposing;
    const Codes a = srgbCodes(pair.a, exposure, transfer),
                b = srgbCodes(pair.b, exposure, transfer);
    switch (layout.mode) {
        case CompareMode::flip: return whole(pair, layout.showsB ? b : a, layout.showsB);
        case CompareMode::difference: return difference(pair, a, b, layout.gain);
        case CompareMode::heat: return heat(pair, a, b);
        case CompareMode::split:
        case CompareMode::wipe: break;
    }
    return split(pair, a, b, layout.at);
}

}  // namespace

int lineColumn(int width, float at)
{
    return std::clamp(static_cast<int>(std::lround(at * static_cast<float>(width))), 0, width);
}

scene::Image shownCodes(const scene::Image& image, const Exposing& exposing)
{
    const Codes codes = srgbCodes(image, exposing.exposure, exposing.transfer);
    return ofCodes(image.width, image.height, [&](size_t i, size_t c) { return codes[3 * i + c]; });
}

ShownImage shownImage(const scene::Image& image, const Exposing& exposing)
{
    ShownImage shown{image.width, image.height, {}, {}};
    shown.radiance.reserve(image.pixelCount());
    for (size_t i = 0; i < image.rgba.size(); i += 4) {
        const auto value = [&](size_t c) {
            const float x = exposing.exposure * image.rgba[i + c];
            return exposing.transfer == Transfer::toneMap ? toneMapped(x)
                                                          : std::clamp(x, 0.0f, 1.0f);
        };
        shown.radiance.emplace_back(value(0), value(1), value(2));
        shown.covered.push_back(image.rgba[i + 3] > 0.0f);
    }
    return shown;
}

std::string numbersText(const scene::CompareNumbers& numbers)
{
    if (numbers.largest == 0.0) return "no difference";
    return fmt::format("PSNR {:.1f} dB, FLIP {:.3f}, dE {:.1f}", numbers.psnrSrgb, numbers.flip,
                       numbers.deltaEItp);
}

scene::Image composed(const ComparePair& pair, const CompareLayout& layout)
{
    scene::Image image = laidOver(pair, layout);
    if (hasRoom(image) && !pair.numbers.empty())
        drawCaption(image, 0, image.width, Corner::bottomRight, pair.numbers);
    return image;
}
scene::Image sideBySide(const ComparePair& pair)
{
    const scene::Image a = composed(pair, {CompareMode::flip}),
                       b = composed(pair, {CompareMode::flip, 0.5f, 1.0f, true});
    scene::Image both(a.width + b.width, a.height);
    for (int y = 0; y < a.height; ++y) {
        std::copy_n(a.pixel(0, y), 4 * a.width, both.pixel(0, y));
        std::copy_n(b.pixel(0, y), 4 * b.width, both.pixel(a.width, y));
    }
    return both;
}

scene::CompareNumbers compareNumbers(const scene::Image& a, const scene::Image& b,
                                     const Exposing& exposing)
{
    ShownImage shownA = shownImage(a, exposing);
    const ShownImage shownB = shownImage(b, exposing);
    scene::CompareNumbers numbers;
    for (size_t i = 0; i < shownA.covered.size(); ++i) {
        shownA.covered[i] = shownA.covered[i] || shownB.covered[i];
        const Vec3f off = glm::abs(shownA.radiance[i] - shownB.radiance[i]);
        numbers.largest = std::max(numbers.largest, double(std::max({off.x, off.y, off.z})));
        numbers.pixels += shownA.covered[i];
    }
    if (numbers.pixels == 0) return numbers;
    const ImageErrors errors = imageErrors(shownA, shownB);
    numbers.psnrLinear = errors.psnrLinear;
    numbers.psnrSrgb = errors.psnrSrgb;
    numbers.ssim = errors.ssim;
    numbers.deltaEItp = errors.deltaEItp;
    numbers.flip = errors.flip;
    return numbers;
}

}  // namespace fbrdf::viewer

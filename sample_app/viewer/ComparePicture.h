// ComparePicture.h - two pictures as a screen shows them, laid over each other, and how far they
// are from each other.
#pragma once
#include <fbrdf/metrics/ImageErrors.h>
#include <fbrdf/scene/CompareView.h>
#include <fbrdf/scene/Image.h>
#include <fbrdf/scene/Stats.h>

#include <string>

namespace fbrdf::viewer {

/// How radiance is shown.
struct Exposing {
    float exposure = 1.0f;
    Transfer transfer = Transfer::srgb;  ///< that or toneMap
};

/// A picture as imageErrors takes it.
ShownImage shownImage(const scene::Image& image, const Exposing& exposing);

/// What a comparison is made of: pictures of one size, with their backgrounds.
struct ComparePair {
    scene::Image a, b;
    Exposing exposing;
    std::string titleA, titleB, numbers;  ///< for labels
};

/// Linear values of the codes that a screen shows: to be written at exposure 1 as sRGB. split and
/// wipe: A in the columns left of `at` times the width, and a line between; flip: A alone, or B
/// where `showsB`. Pictures that have room for them get labels. Without labels and line, a picture
/// compared with itself is that picture.
struct CompareLayout {
    scene::CompareMode mode = scene::CompareMode::split;
    float at = 0.5f, gain = 1.0f;
    bool showsB = false;
};
/// A picture as it is shown: linear values of its codes.
scene::Image shownCodes(const scene::Image& image, const Exposing& exposing);
/// Columns to the left of the line.
int lineColumn(int width, float at);
scene::Image composed(const ComparePair& pair, const CompareLayout& layout);

/// A and B side by side, with labels: what a flip is on paper.
scene::Image sideBySide(const ComparePair& pair);

/// "PSNR 32.6 dB, FLIP 0.130, dE 6.7", or that there is no difference.
std::string numbersText(const scene::CompareNumbers& numbers);

/// Of A against B, over the pixels that either covers before it has a background.
scene::CompareNumbers compareNumbers(const scene::Image& a, const scene::Image& b,
                                     const Exposing& exposing);

}  // namespace fbrdf::viewer

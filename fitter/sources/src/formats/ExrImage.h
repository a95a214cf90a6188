// ExrImage.h - the first part of an OpenEXR file as pixels in memory, whatever its compression.
#pragma once
#include "InputFile.h"

#include <fbrdf/brdf/Conventions.h>

#include <string>
#include <vector>

namespace fbrdf {

struct TableImage {
    size_t width = 0, height = 0;
    std::vector<Vec3f> pixels;  ///< height x width, top line first; grey where there is one channel
    std::string layout, angles;  ///< attributes fbrdf:layout and fbrdf:theta_i, empty if missing

    const Vec3f& at(size_t x, size_t y) const { return pixels[y * width + x]; }
};

/// True for the first bytes of an OpenEXR file.
bool isExr(const InputFile& file);

/// Channels R, G, B, alone or of one layer ("diffuse.R"), or a single channel. Throws Error(input)
/// for other channels, deep images, more than 2^24 pixels, and images that would take far more
/// memory than their file.
TableImage readExrImage(const InputFile& file);

}  // namespace fbrdf

// ExrImage.h - the first part of an OpenEXR file as pixels in memory, whatever its compression.
#pragma once
#include "formats/ImageTable.h"
#include "InputFile.h"

namespace fbrdf {

/// True for the first bytes of an OpenEXR file.
bool isExr(const InputFile& file);

/// Channels R, G, B or X, Y, Z, alone or of one layer ("diffuse.R"), or a single channel, as linear
/// sRGB. The attribute "chromaticities" has the primaries and the white; without it they are those
/// of Rec. 709, and the white of X, Y, Z is D65. Throws Error(input) for other channels, deep
/// images, more than 2^24 pixels, and images that would take far more memory than their file.
TableImage readExrImage(const InputFile& file);

}  // namespace fbrdf

// Png.h - PNG files in memory, written and read through libpng, which prints nothing.
// Images are top row first, channel contiguous, then x, then y.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace fbrdf {

struct PngImage {
    int width = 0, height = 0;
    int channels = 0;             ///< 1 (grey), 3 (R, G, B) or 4 (R, G, B and unassociated alpha)
    int bits = 8;                 ///< 8 or 16
    std::vector<uint16_t> codes;  ///< width x height x channels, 0 to 255 or 65535
};

/// Bytes of a PNG file without time or other context: the same image gives the same bytes. Throws
/// Error(output) naming `where`.
std::string encodePng(const PngImage& image, const std::string& where);

/// The pixels of a whole file. Palettes and fewer than 8 bits are expanded; gamma and colour
/// profiles change nothing. Throws Error(input) that names `where` for anything but a whole PNG of
/// 1 or 3 channels and at most 2^24 pixels.
PngImage decodePng(const std::string& bytes, const std::string& where);

}  // namespace fbrdf

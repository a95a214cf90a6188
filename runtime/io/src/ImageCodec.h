// ImageCodec.h - pixels to and from OpenEXR and PNG. The only file whose source sees OpenImageIO.
// Images are top row first, channel contiguous, then x, then y.
#pragma once
#include "ExrHeader.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace fbrdf {

/// A named value of an OpenEXR header; of what `kind` says.
struct ExrValue {
    enum class Kind { text, integer, integers, real, floats } kind = Kind::text;
    std::string name;
    std::string text;
    int integer = 0;
    std::vector<int> integers;  ///< three
    double real = 0.0;
    std::vector<float> floats;
};

struct ExrImage {
    std::string name;  ///< of the part, unique in its file
    int width = 0, height = 0;
    int channels = 0;   ///< 1 (stored as "Y") or 3 ("R", "G", "B")
    bool half = false;  ///< stored as half; the values must be exact in half
    std::vector<ExrValue> values;
    std::vector<float> pixels;  ///< width x height x channels
};

/// Writes one part an image, ZIP-compressed, all with one display window. The same images give the
/// same bytes. `path` names an existing file. Throws Error(output) naming `where`.
void writeExr(const std::string& path, const std::vector<ExrImage>& images,
              const std::string& where);

/// Pixels of one part of a file that scanExr accepted: width x height x channels. Throws
/// Error(input) naming `where`.
std::vector<float> readExrPixels(const std::string& bytes, size_t part, const ExrPart& expected,
                                 const std::string& where);

struct PngImage {
    int width = 0, height = 0;
    int channels = 0;             ///< 1 or 3
    int bits = 8;                 ///< 8 or 16
    std::vector<uint16_t> codes;  ///< width x height x channels, 0 to 255 or 65535
};

/// Bytes of a PNG file without time or other context: the same image gives the same bytes.
std::string encodePng(const PngImage& image, const std::string& where);

/// Throws Error(input) naming `where` for anything but a PNG of 1 or 3 channels and at most 2^24
/// pixels.
PngImage decodePng(const std::string& bytes, const std::string& where);

}  // namespace fbrdf

// ExrCodec.h - pixels to and from OpenEXR. The only file whose source sees OpenImageIO.
// Images are top row first, channel contiguous, then x, then y.
#pragma once
#include "ExrHeader.h"

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

}  // namespace fbrdf

// Exr.h - OpenEXR files in memory, written through OpenEXR's core library.
// Images are top row first, channel contiguous, then x, then y.
#pragma once
#include <array>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace fbrdf {

/// What an attribute of a header can be; in a file the types are called string, int, double, v3i,
/// v3f and floatvector.
using ExrValue = std::variant<std::string, int, double, std::array<int, 3>, std::array<float, 3>,
                              std::vector<float>>;

struct ExrImage {
    std::string name;  ///< of the part, unique in its file
    int width = 0, height = 0;
    int channels = 0;   ///< 1 (stored as "Y"), 3 ("R", "G", "B") or 4 ("R", "G", "B", "A")
    bool half = false;  ///< stored as half, otherwise as float; what half cannot hold is rounded
    std::vector<std::pair<std::string, ExrValue>> attributes;  ///< in the order of the header
    std::vector<float> pixels;                                 ///< width x height x channels
};

/// Bytes of a file with one part an image, at least one: scan lines, ZIP, all parts with the
/// display window of the largest. No time and no path is in there: the same images give the same
/// bytes. Throws Error(output) that names `where`.
std::string encodeExr(const std::vector<ExrImage>& images, const std::string& where);

}  // namespace fbrdf

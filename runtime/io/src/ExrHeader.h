// ExrHeader.h - the structure of an OpenEXR file, checked before any decoder sees it.
// Sizes, counts and offsets are compared with the bytes that are there, so a hostile header can
// neither make a decoder allocate more than its file could fill nor read past the end.
// Reference: "OpenEXR File Layout", openexr.com (version 2, scan lines, one or more parts).
#pragma once
#include <string>
#include <vector>

namespace fbrdf {

struct ExrAttribute {
    std::string name, type;
    size_t offset = 0, size = 0;  ///< of the value; bytes from the start of the file
};

struct ExrPart {
    std::vector<ExrAttribute> attributes;
    int width = 0, height = 0;
    int firstLine = 0;    ///< y of the data window's first line
    int channels = 0;     ///< 1 ("Y") or 3 ("R", "G", "B")
    bool half = false;    ///< true: all channels are half; false: all are float
    int compression = 0;  ///< none, rle, zips or zip: 0 to 3

    const ExrAttribute* find(const std::string& name) const;
};

/// Scan lines in each chunk of the part; the last chunk may have fewer.
int linesPerChunk(const ExrPart& part);

/// True for the first bytes of an OpenEXR file.
bool looksLikeExr(const std::string& bytes);

/// Headers of all parts, at most 64. Accepts what a material needs and nothing else: scan lines,
/// half or float, lossless compression. Throws Error(input) with `where` and the byte offset.
std::vector<ExrPart> scanExr(const std::string& bytes, const std::string& where);

}  // namespace fbrdf

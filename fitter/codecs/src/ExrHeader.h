// ExrHeader.h - what a decoder of OpenEXR would allocate before anybody could refuse.
#pragma once
#include <cstdint>
#include <string>

namespace fbrdf {

/// True where a panorama in a file of so many bytes may have as many pixels: what compresses best,
/// pixels of one value, takes 1/2048 of a byte and more.
bool mayHavePixels(int64_t pixels, size_t bytes);

/// Throws Error(input) naming `where` where the headers of an OpenEXR file ask for sides, tiles or
/// pixels far beyond what a file of these bytes can have. What is no header is left to the decoder.
void requireSensibleExr(const std::string& bytes, const std::string& where);

}  // namespace fbrdf

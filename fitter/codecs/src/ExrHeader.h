// ExrHeader.h - what a decoder of OpenEXR would allocate before anybody could refuse.
#pragma once
#include <string>

namespace fbrdf {

/// Throws Error(input) naming `where` where the headers of an OpenEXR file ask for sides, tiles or
/// pixels far beyond what a file of these bytes can have. What is no header is left to the decoder.
void requireSensibleExr(const std::string& bytes, const std::string& where);

}  // namespace fbrdf

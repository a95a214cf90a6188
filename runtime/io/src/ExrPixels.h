// ExrPixels.h - pixels of an OpenEXR file in memory, decoded by OpenEXR's core library.
#pragma once
#include "ExrHeader.h"

#include <memory>
#include <string>
#include <vector>

namespace fbrdf {

/// Decodes files that scanExr accepted: OpenEXR 3.1 trusts sizes that only scanExr compares with
/// the bytes that are there.
class ExrPixels {
public:
    /// `bytes` stay where they are for as long as this lives. Throws Error(input) naming `where`.
    ExrPixels(const std::string& bytes, const std::string& where);
    ~ExrPixels();

    /// Pixels of the part at `index`, which scanExr described as `part`: top row first, channel (Y,
    /// or R, G, B) contiguous, then x, then y. Throws Error(input) naming `where`.
    std::vector<float> read(size_t index, const ExrPart& part, const std::string& where);

private:
    struct Decoder;
    std::unique_ptr<Decoder> decoder_;
};

}  // namespace fbrdf

// UnknownFormat.h - what to tell about a file that no reader knows.
#pragma once
#include "Formats.h"

namespace fbrdf {

bool hasExtension(const Format& format, const std::string& extension);

/// Error(input): how the file starts, what it resembles, and which formats have its extension.
Error unknownFormat(const InputFile& file);

}  // namespace fbrdf

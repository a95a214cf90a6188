// Output.h - what the tool prints. See fbrdf/base/OutputFile.h for the files that it writes.
#pragma once
#include <string>
#include <string_view>

namespace fbrdf::tool {

/// Writes to stdout at once, unbuffered. Throws Error(output) when it cannot: a full disk, a closed
/// pipe.
void writeOut(std::string_view text);

/// `text` on one line that a terminal can show: control characters become '?'.
std::string oneLine(std::string text);

}  // namespace fbrdf::tool

// Output.h - what the tool writes: the result on stdout, and files that appear whole or not at all.
#pragma once
#include <string>
#include <string_view>

namespace fbrdf::tool {

/// Writes to stdout at once, unbuffered. Throws Error(output) when it cannot: a full disk, a closed
/// pipe.
void writeOut(std::string_view text);

/// Throws Error(output) unless a file can be made at `path`: its folder exists and can be written,
/// and `path` is not a folder or a device. Leaves nothing behind. For use before long work.
void requireWritable(const std::string& path);

/// Replaces the file at `path` by one with this content, in one step. Throws Error(output).
void writeWhole(const std::string& path, std::string_view content);

/// `text` on one line that a terminal can show: control characters become '?'.
std::string oneLine(std::string text);

}  // namespace fbrdf::tool

// TextFile.h - whole text files in, and whole files out or none.
#pragma once
#include <functional>
#include <string>

namespace fbrdf::scene {

/// All bytes of a file. Throws Error(input, path, "found ..., expected WHAT").
std::string readText(const std::string& path, const std::string& what);

/// Calls `write` with the path of a new file beside `path` and moves it there; on any failure
/// nothing new is left and what was at `path` stays. The extension is kept, because writers go by
/// it. `write` throws; so does this: Error(output, path, ...).
void writeWhole(const std::string& path, const std::function<void(const std::string&)>& write);

/// writeWhole of a string.
void writeText(const std::string& path, const std::string& text);

}  // namespace fbrdf::scene

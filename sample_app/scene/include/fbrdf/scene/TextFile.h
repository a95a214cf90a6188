// TextFile.h - whole text files.
#pragma once
#include <string>

namespace fbrdf::scene {

/// All bytes of a file. Throws Error(input, path, "found ..., expected WHAT").
std::string readText(const std::string& path, const std::string& what);

}  // namespace fbrdf::scene

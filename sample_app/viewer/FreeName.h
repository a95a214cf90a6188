// FreeName.h - names for files that the user gave none.
#pragma once
#include <string>

namespace fbrdf::viewer {

/// The first of "STEM-001ENDING", "STEM-002ENDING", ... that is not taken.
std::string freeName(const std::string& stem, const std::string& ending);

}  // namespace fbrdf::viewer

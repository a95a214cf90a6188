// AtomicFile.h - a file that appears whole or not at all.
#pragma once
#include <string>

namespace fbrdf {

/// Writes beside `path`, then renames. Throws Error(output) naming `path`; nothing is left behind.
void writeFileAtomically(const std::string& path, const std::string& content);

}  // namespace fbrdf

// Files.h - whole files in. See fbrdf/base/OutputFile.h for files out.
#pragma once
#include <string>

namespace fbrdf {

/// Bytes of a regular file. Throws Error(input) for one that is missing, not a regular file, or
/// above 256 MiB.
std::string readFile(const std::string& path);

/// The first bytes of a regular file, at most `count`; empty when it cannot be read.
std::string readBeginning(const std::string& path, size_t count);

}  // namespace fbrdf

// Files.h - whole files in, and a folder for temporary ones. See OutputFile.h for files out.
#pragma once
#include <string>

namespace fbrdf {

/// Bytes of a regular file. Throws Error(input) for one that is missing, not a regular file, or
/// above 256 MiB.
std::string readFile(const std::string& path);

/// The first bytes of a regular file, at most `count`; empty when it cannot be read.
std::string readBeginning(const std::string& path, size_t count);

/// A folder that nobody else has, for as long as this lives.
class TemporaryFolder {
public:
    /// Throws Error(output) where the system's folder for temporary files takes none.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    /// Path of a file in it.
    std::string file(const std::string& name) const { return path_ + "/" + name; }

private:
    std::string path_;
};

}  // namespace fbrdf

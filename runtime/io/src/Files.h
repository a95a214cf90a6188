// Files.h - whole files in, whole files out. Nothing half-written is ever seen at a target's path.
#pragma once
#include <string>
#include <utility>
#include <vector>

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

/// Files that appear together or not at all: each is written under a temporary name beside its
/// target, commit() renames them in the order they were added, and the destructor removes what was
/// not committed. A target that is a symbolic link is followed.
class PendingFiles {
public:
    PendingFiles() = default;
    PendingFiles(const PendingFiles&) = delete;
    PendingFiles& operator=(const PendingFiles&) = delete;
    ~PendingFiles();

    /// Creates the temporary file and returns its path. Throws Error(output) when the target's
    /// folder does not allow it or the target is a folder or a device.
    std::string add(const std::string& target);
    /// add(), and writes the file's content.
    void add(const std::string& target, const std::string& bytes);
    /// Throws Error(output).
    void commit();

private:
    struct Entry {
        std::string temporary, target;
    };
    std::vector<Entry> entries_;
};

}  // namespace fbrdf

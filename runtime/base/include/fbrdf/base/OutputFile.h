// OutputFile.h - files that appear at their paths complete, or not at all.
//
// The bytes go to a temporary file in the same folder, which a rename puts in place: readers see
// the old file or the new one, and a failure at any point leaves the old one and nothing else. As
// with a file that is opened for writing:
// - a symbolic link is followed, and what it names is replaced or made;
// - a file that exists keeps its permissions and must be writable; a new one gets what the umask
//   allows.
// What a rename would destroy is refused: folders, devices, pipes, sockets, and links to streams
// that are open already (/dev/stdout). Every failure is an Error(output) that names the path.
#pragma once
#include <cstdio>
#include <list>
#include <string>
#include <string_view>

namespace fbrdf {

/// One such file.
class OutputFile {
public:
    /// Creates the temporary file. Its name is new: a name that is taken, by another writer of the
    /// same path or by what a killed process left, is passed over.
    explicit OutputFile(const std::string& path);
    /// Removes the temporary file unless it was committed.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Appends to the temporary file, through a buffer.
    void write(std::string_view bytes);
    /// Ends the writing. A full disk may show here for the first time.
    void close();
    /// Closes the file unless it is closed, and renames it to the path.
    void commit();

    /// Path of the temporary file, for libraries that write to a path of their own accord. They
    /// must neither replace nor remove it. Not for use together with write().
    const std::string& temporary() const { return temporary_; }

private:
    std::string path_, target_, temporary_;
    std::FILE* file_ = nullptr;
};

/// Several such files, which appear together: none is put in place before all are written.
class OutputFiles {
public:
    /// Adds a file, and writes its content.
    void add(const std::string& path, std::string_view bytes);
    /// Closes all files, then renames them in the order in which they were added.
    void commit();

private:
    std::list<OutputFile> files_;
};

/// Writes a whole file.
void writeFile(const std::string& path, std::string_view bytes);

/// Throws Error(output) where an OutputFile could not be made at `path`, and leaves nothing behind.
/// For use before long work.
void requireWritable(const std::string& path);

}  // namespace fbrdf

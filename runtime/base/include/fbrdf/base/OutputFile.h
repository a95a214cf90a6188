// OutputFile.h - files that appear at their paths complete, or not at all.
//
// The bytes go to a file without a name in the same folder, which gets one when it is complete, or
// takes the place of the old file by a rename: readers see the old file or the new one, and a
// failure at any point leaves the old one and nothing else, a process that is killed (Ctrl-C)
// included. Where the file system knows no files without names, it is a temporary name, which a
// killed process leaves. As with a file that is opened for writing:
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
    /// Creates the file that is written. Its name, where it has one, is new: a name that is taken,
    /// by another writer of the same path or by what a killed process left, is passed over.
    explicit OutputFile(const std::string& path);
    /// Removes what was written unless it was committed.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Appends, through a buffer.
    void write(std::string_view bytes);
    /// Ends the writing. A full disk may show here for the first time.
    void close();
    /// Closes the file unless it is closed, and puts it at the path.
    void commit();

private:
    void place();

    std::string path_, target_;
    std::string temporary_;      ///< name of the file; empty where it has none
    int unnamed_ = -1;           ///< descriptor of the file; -1 where it has a name
    std::FILE* file_ = nullptr;  ///< what is written to; null when it is closed
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

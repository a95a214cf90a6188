// OutputFile.h - a file that appears at its path only when it is complete.
#pragma once
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace fbrdf {

class OutputFile {
public:
    /// Creates a temporary file beside `path`. Throws Error(output).
    explicit OutputFile(const std::string& path);
    /// Removes what was not committed.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Throws Error(output), as when the disk is full.
    void write(std::string_view bytes);
    /// Gives the file its name. Throws Error(output).
    void commit();

private:
    [[noreturn]] void fail() const;

    std::string path_, temporary_;
    std::FILE* file_ = nullptr;
};

}  // namespace fbrdf

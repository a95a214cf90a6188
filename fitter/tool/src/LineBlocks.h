// LineBlocks.h - a file, a pipe or stdin as runs of whole lines of UTF-8 that end in "\n", in
// constant memory.
#pragma once
#include <fbrdf/sources/TextDecoder.h>

#include <atomic>
#include <cstdint>
#include <string>

namespace fbrdf::tool {

struct LineBlock {
    std::string text;      ///< whole lines; the last of the input may lack its newline
    size_t firstLine = 1;  ///< number of its first line, from 1
};

class LineBlocks {
public:
    /// "-" is stdin. Throws Error(input) when the file cannot be opened or is a folder.
    explicit LineBlocks(const std::string& path);
    ~LineBlocks();
    LineBlocks(const LineBlocks&) = delete;
    LineBlocks& operator=(const LineBlocks&) = delete;

    /// Reads the next lines: a megabyte, or fewer where more have not arrived yet. Returns false at
    /// the end. Throws Error(input) for what cannot be read, and for a line of a megabyte.
    bool next(LineBlock& block);

    /// The path, or "standard input".
    const std::string& name() const { return name_; }
    /// "NAME:N"
    std::string where(size_t line) const { return name_ + ":" + std::to_string(line); }
    /// Bytes read so far, and bytes in all; the latter is 0 where it is not known (a pipe).
    uint64_t bytesRead() const { return bytesRead_; }
    uint64_t size() const { return size_; }

private:
    bool readMore(std::string& text);
    bool mustWait() const;

    std::string name_;
    int descriptor_;
    uint64_t size_ = 0;
    std::atomic<uint64_t> bytesRead_{0};  // atomic, for the thread that shows progress
    std::string bytes_;                   // as read, before they are decoded
    TextDecoder decoder_;
    std::string rest_;  // the beginning of a line whose end has not been read
    size_t line_ = 1;
    bool ended_ = false;
};

}  // namespace fbrdf::tool

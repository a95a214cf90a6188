// InputFile.h - the bytes of a file that is being read: in memory or mapped, whichever suits its
// size. Text comes as UTF-8 without a byte order mark, whichever encoding that mark names.
#pragma once
#include <fbrdf/base/Error.h>

#include <string>
#include <string_view>

namespace fbrdf {

/// Files from this size on are mapped instead of read. Below it a file that shrinks while it is
/// being read cannot hurt (a mapping would raise SIGBUS).
constexpr size_t kMapFrom = size_t(64) << 20;

class InputFile {
public:
    /// Throws Error(input) for a path that is missing, not readable, a directory or a device, and
    /// for an empty file.
    explicit InputFile(const std::string& path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::string& path() const { return path_; }
    std::string_view bytes() const { return view_; }
    size_t size() const { return view_.size(); }
    /// Releases a range of bytes that is not needed for now: a mapped file gives its memory back,
    /// so that reading once through a file takes no more than a block.
    void release(size_t first, size_t count) const;
    /// Name without folder and extension.
    std::string stem() const;
    /// Lower case, without the dot.
    std::string extension() const;
    /// Folder of the file, "." when the path names none.
    std::string folder() const;

private:
    void readAll(int descriptor, size_t expected);
    void mapAll(int descriptor, size_t size);
    void unmap();
    void decodeText();

    std::string path_;
    std::string held_;
    void* mapped_ = nullptr;
    size_t mappedSize_ = 0;
    std::string_view view_;
};

/// Error(input) at a byte of a file.
Error inputError(const InputFile& file, uint64_t byte, const std::string& what);
/// Error(input) about the file as a whole.
Error inputError(const InputFile& file, const std::string& what);
/// Error(input) at a line, counted from 1.
Error lineError(const InputFile& file, size_t line, const std::string& what);

}  // namespace fbrdf

#include "InputFile.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>
#include <fbrdf/sources/TextDecoder.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace fbrdf {
namespace {

/// What a pipe may deliver before it is refused: no reader needs more without a mapping.
constexpr size_t kPipeLimit = size_t(4) << 30;

class Descriptor {
public:
    explicit Descriptor(int value) : value_(value) {}
    ~Descriptor()
    {
        if (value_ >= 0) ::close(value_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return value_; }

private:
    int value_;
};

Error systemError(const std::string& path, const std::string& expected)
{
    return Error(ErrorKind::input, path, Found(systemErrorText(errno)).expected(expected));
}

}  // namespace

InputFile::InputFile(const std::string& path) : path_(path)
{
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat status {};
    if (file.get() < 0 || ::fstat(file.get(), &status) != 0)
        throw systemError(path, "a readable file");
    if (S_ISDIR(status.st_mode))
        throw Error(ErrorKind::input, path, Found("a directory").expected("a file"));
    if (!S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode))
        throw Error(ErrorKind::input, path, Found("a device or socket").expected("a file"));
    const size_t size = static_cast<size_t>(status.st_size);
    if (S_ISREG(status.st_mode) && size >= kMapFrom)
        mapAll(file.get(), size);
    else
        readAll(file.get(), size);
    if (view_.empty())
        throw Error(ErrorKind::input, path, Found("an empty file").expected("reflectance data"));
    decodeText();
}

InputFile::~InputFile()
{
    unmap();
}

void InputFile::unmap()
{
    if (mapped_) ::munmap(mapped_, mappedSize_);
    mapped_ = nullptr;
}

void InputFile::decodeText()
{
    if (!startsAsUtf16(view_)) {
        const std::string_view text = withoutByteOrderMark(view_);
        if (!text.empty()) view_ = text;
        return;
    }
    std::string start;
    TextDecoder().append(view_.substr(0, 4096), start);
    if (!looksLikeText(start)) return;
    TextDecoder decoder;
    std::string text;
    decoder.append(view_, text);
    decoder.finish(text);
    if (text.empty()) return;
    unmap();
    held_ = std::move(text);
    view_ = held_;
}

void InputFile::readAll(int descriptor, size_t expected)
{
    size_t used = 0;
    held_.resize(expected + 1);  // one more, so that the end is seen without growing
    for (;;) {
        const ssize_t got = ::read(descriptor, held_.data() + used, held_.size() - used);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw systemError(path_, "a readable file");
        if (got == 0) break;
        used += static_cast<size_t>(got);
        if (used > kPipeLimit)
            throw Error(ErrorKind::input, path_,
                        Found("a pipe of more than 4 GiB").expected("a file"));
        if (used == held_.size()) held_.resize(std::max<size_t>(2 * used, 65536));
    }
    held_.resize(used);
    view_ = held_;
}

void InputFile::mapAll(int descriptor, size_t size)
{
    void* address = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
    if (address == MAP_FAILED) throw systemError(path_, "a file that can be mapped");
    mapped_ = address;
    mappedSize_ = size;
    view_ = std::string_view(static_cast<const char*>(address), size);
}

void InputFile::release(size_t first, size_t count) const
{
    if (!mapped_) return;
    // Whole pages only; the two at the ends may be in use by a neighbouring block, and are read
    // again when they are.
    const size_t page = static_cast<size_t>(::sysconf(_SC_PAGESIZE));
    first += static_cast<size_t>(view_.data() - static_cast<const char*>(mapped_));
    const size_t begin = first / page * page;
    const size_t end = std::min((first + count + page - 1) / page * page, mappedSize_);
    if (end > begin) ::madvise(static_cast<char*>(mapped_) + begin, end - begin, MADV_DONTNEED);
}

std::string InputFile::stem() const
{
    return std::filesystem::path(path_).stem().string();
}

std::string InputFile::extension() const
{
    const std::string extension = std::filesystem::path(path_).extension().string();
    return extension.empty() ? extension : lowerCase(extension.substr(1));
}

std::string InputFile::folder() const
{
    const std::string parent = std::filesystem::path(path_).parent_path().string();
    return parent.empty() ? "." : parent;
}

Error inputError(const InputFile& file, uint64_t byte, const std::string& what)
{
    return Error(ErrorKind::input, file.path() + " at byte " + std::to_string(byte), what);
}

Error inputError(const InputFile& file, const std::string& what)
{
    return Error(ErrorKind::input, file.path(), what);
}

Error lineError(const InputFile& file, size_t line, const std::string& what)
{
    return Error(ErrorKind::input, file.path() + ":" + std::to_string(line), what);
}

}  // namespace fbrdf

#include "Output.h"

#include <fbrdf/base/Error.h>

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace fbrdf::tool {
namespace {

[[noreturn]] void fail(const std::string& path, int number)
{
    throw Error(ErrorKind::output, path,
                std::string("cannot be written: ") + std::strerror(number));
}

/// False with errno set when not all of it could be written.
bool writeAll(int descriptor, std::string_view text)
{
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno != EINTR) return false;
        if (written > 0) text.remove_prefix(static_cast<size_t>(written));
    }
    return true;
}

// Two runs that write the same file must not share a temporary one.
std::string temporaryBeside(const std::string& path)
{
    return path + ".part-" + std::to_string(::getpid());
}

int createNew(const std::string& path, const std::string& target)
{
    const int file = ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file < 0) fail(target, errno);
    return file;
}

}  // namespace

void writeOut(std::string_view text)
{
    if (!writeAll(STDOUT_FILENO, text)) fail("standard output", errno);
}

void requireWritable(const std::string& path)
{
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw Error(ErrorKind::output, path,
                    "found a folder or a device, expected a file or nothing");
    const std::string temporary = temporaryBeside(path);
    ::close(createNew(temporary, path));
    ::unlink(temporary.c_str());
}

void writeWhole(const std::string& path, std::string_view content)
{
    const std::string temporary = temporaryBeside(path);
    const int file = createNew(temporary, path);
    bool good = writeAll(file, content);
    int number = errno;
    if (::close(file) != 0 && good) {  // data may reach the disk only now
        good = false;
        number = errno;
    }
    if (good && std::rename(temporary.c_str(), path.c_str()) == 0) return;
    if (good) number = errno;
    ::unlink(temporary.c_str());
    fail(path, number);
}

std::string oneLine(std::string text)
{
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
    return text;
}

}  // namespace fbrdf::tool

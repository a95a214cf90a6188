#include "OutputFile.h"

#include <fbrdf/base/Error.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace fbrdf {
namespace {

namespace fs = std::filesystem;

/// Where the bytes go in the end: a rename must not replace a link by a file, nor a device.
std::string resolved(const std::string& path)
{
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (!fs::exists(status)) return path;
    if (!fs::is_regular_file(status))
        throw Error(ErrorKind::output, path, "found a folder or a device, expected a file");
    const fs::path canonical = fs::canonical(path, ignored);
    return canonical.empty() ? path : canonical.string();
}

}  // namespace

OutputFile::OutputFile(const std::string& path)
    : path_(resolved(path)), temporary_(path_ + ".part" + std::to_string(::getpid()))
{
    // O_EXCL: a name that is taken belongs to somebody else, and may be a link to anywhere.
    for (int i = 0; i < 100; ++i) {
        const std::string name = temporary_ + "-" + std::to_string(i);
        const int file = ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (file < 0 && errno == EEXIST) continue;
        if (file >= 0) {
            temporary_ = name;
            file_ = ::fdopen(file, "wb");
        }
        break;
    }
    if (!file_) fail();
}

OutputFile::~OutputFile()
{
    if (!file_) return;
    std::fclose(file_);
    std::remove(temporary_.c_str());
}

void OutputFile::write(std::string_view bytes)
{
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) fail();
}

void OutputFile::commit()
{
    std::FILE* file = file_;
    file_ = nullptr;
    const bool closed = std::fclose(file) == 0;  // a full disk may show only here
    if (closed && std::rename(temporary_.c_str(), path_.c_str()) == 0) return;
    const int error = errno;
    std::remove(temporary_.c_str());
    errno = error;
    fail();
}

void OutputFile::fail() const
{
    throw Error(ErrorKind::output, path_,
                std::string("cannot be written: ") + std::strerror(errno));
}

}  // namespace fbrdf

#include "Files.h"

#include <fbrdf/base/Error.h>

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace fbrdf {
namespace {

namespace fs = std::filesystem;

// Far above any material (a 64 x 16 + 16 x 16 table is 4 KB), far below what exhausts memory.
constexpr uintmax_t kMaxFileBytes = uintmax_t(256) << 20;
// Temporary names that may be taken already: by threads that write the same target, or left by
// processes that were killed.
constexpr int kMaxTemporaries = 1000;

[[noreturn]] void failOutput(const std::string& path, const std::string& what)
{
    throw Error(ErrorKind::output, path, what);
}

// Where the bytes go in the end: a link's destination, so that a rename does not replace the link.
fs::path resolvedTarget(const std::string& target)
{
    std::error_code error;
    const fs::file_status status = fs::status(target, error);
    if (!fs::exists(status)) return target;
    if (!fs::is_regular_file(status))
        failOutput(target, "found a folder or a device, expected a file or nothing");
    const fs::path canonical = fs::canonical(target, error);
    return error ? fs::path(target) : canonical;
}

// O_EXCL makes the name ours; mode 0666 lets the umask decide, as for any other output file.
std::string createTemporary(const std::string& target)
{
    for (int i = 0; i < kMaxTemporaries; ++i) {
        const std::string path = target + ".part" + std::to_string(i);
        const int file = ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (file >= 0) {
            ::close(file);
            return path;
        }
        if (errno != EEXIST) break;
    }
    failOutput(target, std::string("cannot be written: ") + std::strerror(errno));
}

void writeBytes(const std::string& path, const std::string& bytes, const std::string& target)
{
    std::FILE* file = std::fopen(path.c_str(), "wb");
    bool good = file && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    // Data may reach the disk only on closing: a full disk shows up here.
    if (file && std::fclose(file) != 0) good = false;
    if (!good) failOutput(target, std::string("cannot be written: ") + std::strerror(errno));
}

}  // namespace

std::string readFile(const std::string& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) throw Error(ErrorKind::input, path, "not found, expected a file");
    if (!fs::is_regular_file(status))
        throw Error(ErrorKind::input, path, "found a folder or a device, expected a file");
    const uintmax_t size = fs::file_size(path, error);
    if (error || size > kMaxFileBytes)
        throw Error(ErrorKind::input, path,
                    "found " + std::to_string(size) + " bytes, expected at most " +
                        std::to_string(kMaxFileBytes));
    std::ifstream file(path, std::ios::binary);
    std::string bytes(size, '\0');
    if (!file.read(bytes.data(), static_cast<std::streamsize>(size)))
        throw Error(ErrorKind::input, path, "cannot be read");
    return bytes;
}

std::string readBeginning(const std::string& path, size_t count)
{
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return {};
    std::ifstream file(path, std::ios::binary);
    std::string bytes(count, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<size_t>(file.gcount()));
    return bytes;
}

TemporaryFolder::TemporaryFolder()
{
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    path_ = ((error ? fs::path("/tmp") : folder) / "fbrdf-XXXXXX").string();
    if (!::mkdtemp(path_.data()))
        failOutput(path_, std::string("cannot be made: ") + std::strerror(errno));
}

TemporaryFolder::~TemporaryFolder()
{
    std::error_code error;
    fs::remove_all(path_, error);
}

PendingFiles::~PendingFiles()
{
    for (const Entry& entry : entries_) std::remove(entry.temporary.c_str());
}

std::string PendingFiles::add(const std::string& target)
{
    const std::string resolved = resolvedTarget(target).string();
    entries_.push_back({createTemporary(resolved), resolved});
    return entries_.back().temporary;
}

void PendingFiles::add(const std::string& target, const std::string& bytes)
{
    writeBytes(add(target), bytes, target);
}

void PendingFiles::commit()
{
    while (!entries_.empty()) {
        const Entry entry = entries_.front();
        if (std::rename(entry.temporary.c_str(), entry.target.c_str()) != 0)
            failOutput(entry.target, std::string("cannot be written: ") + std::strerror(errno));
        entries_.erase(entries_.begin());
    }
}

}  // namespace fbrdf

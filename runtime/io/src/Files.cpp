#include "Files.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <filesystem>
#include <fstream>

namespace fbrdf {
namespace {

namespace fs = std::filesystem;

// This is far above any material (the tables of hdio have some 4 KB) and far below what exhausts
// memory.
constexpr uintmax_t kMaxFileBytes = uintmax_t(256) << 20;

}  // namespace

std::string readFile(const std::string& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        throw Error(ErrorKind::input, path, Found("no such file").expected("one"));
    // A pipe would block, and a device may never end.
    if (!fs::is_regular_file(status))
        throw Error(ErrorKind::input, path, Found("a folder or a device").expected("a file"));
    const uintmax_t size = fs::file_size(path, error);
    if (error || size > kMaxFileBytes)
        throw Error(ErrorKind::input, path,
                    Found(std::to_string(size) + " bytes")
                        .expected("at most " + std::to_string(kMaxFileBytes)));
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

}  // namespace fbrdf

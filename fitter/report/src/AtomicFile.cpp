#include "AtomicFile.h"

#include <fbrdf/base/Error.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace fbrdf {

void writeFileAtomically(const std::string& path, const std::string& content)
{
    namespace fs = std::filesystem;
    // In the same folder, since a rename is atomic within a file system only; of this process, so
    // that two do not meet.
    const std::string temporary = path + "." + std::to_string(getpid()) + ".part";
    const auto fail = [&](const char* what) {
        const int code = errno;
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw Error(ErrorKind::output, path,
                    std::string("found that it cannot be ") + what + " (" + std::strerror(code) +
                        "), expected a place that can be written");
    };
    errno = 0;
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
        errno = EISDIR;
        fail("written");
    }
    std::ofstream file(temporary, std::ios::binary);
    if (!file) fail("opened");
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file) fail("written");
    if (std::rename(temporary.c_str(), path.c_str()) != 0) fail("put in place");
}

}  // namespace fbrdf

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/scene/TextFile.h>

#include <filesystem>
#include <fstream>

namespace fbrdf::scene {

namespace fs = std::filesystem;

std::string readText(const std::string& path, const std::string& what)
{
    const auto fail = [&](const char* found) {
        throw Error(ErrorKind::input, path, Found(found).expected(what));
    };
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) fail("no such file");
    if (fs::is_directory(status)) fail("a folder");
    std::ifstream file(path, std::ios::binary);
    if (!file) fail("a file that cannot be opened");
    std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad()) fail("a file that cannot be read");
    return text;
}

}  // namespace fbrdf::scene

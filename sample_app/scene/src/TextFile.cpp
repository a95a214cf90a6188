#include <fbrdf/base/Error.h>
#include <fbrdf/scene/TextFile.h>

#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fbrdf::scene {
namespace fs = std::filesystem;
namespace {

/// "dir/.name.PID.ext": in the same folder, so that the move is one rename.
fs::path temporaryBeside(const fs::path& path)
{
    const std::string name =
        "." + path.stem().string() + "." + std::to_string(getpid()) + path.extension().string();
    return path.parent_path() / name;
}

/// Removes the temporary file unless it has been moved away.
struct Cleanup {
    fs::path path;
    ~Cleanup()
    {
        std::error_code ignored;
        fs::remove(path, ignored);
    }
};

}  // namespace

std::string readText(const std::string& path, const std::string& what)
{
    const auto fail = [&](const char* found) {
        throw Error(ErrorKind::input, path, std::string("found ") + found + ", expected " + what);
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

void writeWhole(const std::string& path, const std::function<void(const std::string&)>& write)
{
    const Cleanup temporary{temporaryBeside(path)};
    write(temporary.path.string());
    std::error_code error;
    fs::rename(temporary.path, path, error);
    if (error) throw Error(ErrorKind::output, path, "cannot be written there: " + error.message());
}

void writeText(const std::string& path, const std::string& text)
{
    writeWhole(path, [&](const std::string& temporary) {
        std::ofstream file(temporary, std::ios::binary);
        file << text;
        file.close();
        if (!file)
            throw Error(ErrorKind::output, path, "found no way to write, expected a writable path");
    });
}

}  // namespace fbrdf::scene

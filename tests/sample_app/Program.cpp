#include "Program.h"

#include <fbrdf/scene/TextFile.h>
#include <support/BuiltFile.h>
#include <support/TemporaryDir.h>
#include <sys/wait.h>

#include <OpenImageIO/imageio.h>

#include <cstdlib>
#include <filesystem>

namespace fbrdf::scene {

ProgramResult runProgram(const std::string& program, const std::string& arguments,
                         const std::string& prefix)
{
    const test::TemporaryDir dir;
    const std::string command = prefix + " '" + program + "' " + arguments + " >'" +
                                dir.file("out") + "' 2>'" + dir.file("err") + "'";
    const int status = std::system(command.c_str());
    ProgramResult result;
    if (WIFEXITED(status)) result.exitCode = WEXITSTATUS(status);
    result.out = readText(dir.file("out"), "what it printed");
    result.err = readText(dir.file("err"), "what it complained about");
    return result;
}

std::string viewerPath()
{
    return test::builtFile("FBRDF_VIEWER", FBRDF_VIEWER_PATH);
}

ProgramResult runViewer(const std::string& arguments, const std::string& prefix)
{
    return runProgram(viewerPath(), arguments, prefix);
}

Image readExr(const std::string& path)
{
    const auto file = OIIO::ImageInput::open(path);
    if (!file) throw std::runtime_error(OIIO::geterror());
    Image image(file->spec().width, file->spec().height);
    if (file->spec().nchannels != 4 ||
        !file->read_image(0, 0, 0, 4, OIIO::TypeDesc::FLOAT, image.rgba.data()))
        throw std::runtime_error("no RGBA image: " + path);
    return image;
}

nlohmann::json readJson(const std::string& path)
{
    return nlohmann::json::parse(readText(path, "JSON"));
}

bool hasCommand(const std::string& name)
{
    return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

}  // namespace fbrdf::scene

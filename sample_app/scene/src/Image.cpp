#include <fbrdf/base/Error.h>
#include <fbrdf/base/Srgb.h>
#include <fbrdf/scene/Image.h>
#include <fbrdf/scene/TextFile.h>

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <filesystem>

namespace fbrdf::scene {
namespace {

bool isExr(const std::string& path)
{
    return std::filesystem::path(path).extension() == ".exr";
}

/// Opens, writes and closes one file; `finalPath` is what errors name.
void writeWithOiio(const std::string& path, const std::string& finalPath,
                   const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type, const void* pixels)
{
    const auto fail = [&finalPath](const std::string& reason) {
        throw Error(ErrorKind::output, finalPath, "cannot be written: " + reason);
    };
    const auto file = OIIO::ImageOutput::create(path);
    if (!file) fail(OIIO::geterror());
    if (!file->open(path, spec) || !file->write_image(type, pixels) || !file->close())
        fail(file->geterror());
}

std::vector<uint8_t> srgbPixels(const Image& image, float exposure)
{
    std::vector<uint8_t> codes;
    codes.reserve(3 * image.pixelCount());
    for (size_t i = 0; i < image.rgba.size(); i += 4)
        for (size_t c = 0; c < 3; ++c) codes.push_back(srgbCode(exposure * image.rgba[i + c]));
    return codes;
}

}  // namespace

uint8_t srgbCode(float linear)
{
    if (!(linear > 0.0f)) return 0;
    return static_cast<uint8_t>(std::lround(255.0 * srgbFromLinear(double(linear))));
}

void checkImagePath(const std::string& path)
{
    const auto extension = std::filesystem::path(path).extension();
    if (extension != ".exr" && extension != ".png")
        throw Error(ErrorKind::usage, "--out",
                    "found '" + path + "', expected a name that ends in .exr or .png");
}

void writeImage(const Image& image, const std::string& path, float exposure)
{
    checkImagePath(path);
    writeWhole(path, [&](const std::string& temporary) {
        if (isExr(path)) {
            OIIO::ImageSpec spec(image.width, image.height, 4, OIIO::TypeDesc::FLOAT);
            spec.attribute("oiio:ColorSpace", "lin_rec709");
            writeWithOiio(temporary, path, spec, OIIO::TypeDesc::FLOAT, image.rgba.data());
        } else {
            OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
            spec.attribute("oiio:ColorSpace", "sRGB");
            writeWithOiio(temporary, path, spec, OIIO::TypeDesc::UINT8,
                          srgbPixels(image, exposure).data());
        }
    });
}

}  // namespace fbrdf::scene

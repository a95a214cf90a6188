#include <fbrdf/base/Error.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/base/Srgb.h>
#include <fbrdf/scene/Image.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cmath>
#include <filesystem>

namespace fbrdf::scene {
namespace {

bool isExr(const std::string& path)
{
    return std::filesystem::path(path).extension() == ".exr";
}

/// The bytes of a file. `path` is what errors name; its extension decides on the format.
std::string encoded(const std::string& path, const OIIO::ImageSpec& spec, const void* pixels)
{
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto writer = OIIO::ImageOutput::create(path);
    if (!writer || !writer->set_ioproxy(&memory) || !writer->open(path, spec) ||
        !writer->write_image(spec.format, pixels) || !writer->close())
        throw Error(ErrorKind::output, path,
                    "cannot be encoded: " + (writer ? writer->geterror() : OIIO::geterror()));
    return std::string(bytes.begin(), bytes.end());
}

std::vector<uint8_t> srgbPixels(const Image& image, float exposure)
{
    std::vector<uint8_t> codes;
    codes.reserve(3 * image.pixelCount());
    for (size_t i = 0; i < image.rgba.size(); i += 4)
        for (size_t c = 0; c < 3; ++c) codes.push_back(srgbCode(exposure * image.rgba[i + c]));
    return codes;
}

std::string exrOf(const Image& image, const std::string& path)
{
    OIIO::ImageSpec spec(image.width, image.height, 4, OIIO::TypeDesc::FLOAT);
    spec.attribute("oiio:ColorSpace", "lin_rec709");
    return encoded(path, spec, image.rgba.data());
}

std::string pngOf(const Image& image, const std::string& path, float exposure)
{
    OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    return encoded(path, spec, srgbPixels(image, exposure).data());
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
    writeFile(path, isExr(path) ? exrOf(image, path) : pngOf(image, path, exposure));
}

}  // namespace fbrdf::scene

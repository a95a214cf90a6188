#include <fbrdf/base/Error.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/base/Srgb.h>
#include <fbrdf/pictures/Exr.h>
#include <fbrdf/pictures/Png.h>
#include <fbrdf/scene/Image.h>

#include <cmath>
#include <filesystem>

namespace fbrdf::scene {
namespace {

bool isExr(const std::string& path)
{
    return std::filesystem::path(path).extension() == ".exr";
}

std::string exrOf(const Image& image, const std::string& path)
{
    return encodeExr({{"", image.width, image.height, 4, false, {}, image.rgba}}, path);
}

std::string pngOf(const Image& image, const std::string& path, float exposure)
{
    std::vector<uint16_t> codes;
    codes.reserve(3 * image.pixelCount());
    for (size_t i = 0; i < image.rgba.size(); i += 4)
        for (size_t c = 0; c < 3; ++c) codes.push_back(srgbCode(exposure * image.rgba[i + c]));
    return encodePng({image.width, image.height, 3, 8, codes}, path);
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

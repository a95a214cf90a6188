#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/base/Srgb.h>
#include <fbrdf/codecs/PictureFile.h>
#include <fbrdf/pictures/Exr.h>
#include <fbrdf/pictures/Png.h>
#include <fbrdf/scene/Image.h>

#include <cmath>
#include <filesystem>

namespace fbrdf::scene {
namespace {

/// Extension of a path in lower case.
std::string extensionOf(const std::string& path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
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

float radianceSample(float linear, float /*exposure*/)
{
    return linear;
}

float srgbSample(float linear, float exposure)
{
    const float exposed = exposure * linear;
    return exposed > 0.0f ? static_cast<float>(srgbFromLinear(double(exposed))) : 0.0f;
}

/// Pictures of formats that a module writes; none of them has coverage.
std::string pictureOf(const Image& image, const PictureFormat& format, const std::string& path,
                      float exposure)
{
    const auto sample = format.encoding == PictureEncoding::linear ? radianceSample : srgbSample;
    PictureSamples picture{image.width, image.height, 3, {}};
    picture.samples.reserve(3 * image.pixelCount());
    for (size_t i = 0; i < image.rgba.size(); i += 4)
        for (size_t c = 0; c < 3; ++c)
            picture.samples.push_back(sample(image.rgba[i + c], exposure));
    return encodePicture(picture, format, path);
}

std::string fileOf(const Image& image, const std::string& path, float exposure)
{
    const std::string extension = extensionOf(path);
    if (extension == ".exr") return exrOf(image, path);
    if (extension == ".png") return pngOf(image, path, exposure);
    return pictureOf(image, *pictureFormatOf(path), path, exposure);
}

}  // namespace

uint8_t srgbCode(float linear)
{
    if (!(linear > 0.0f)) return 0;
    return static_cast<uint8_t>(std::lround(255.0 * srgbFromLinear(double(linear))));
}

void checkImagePath(const std::string& path)
{
    const std::string extension = extensionOf(path);
    if (extension == ".exr" || extension == ".png") return;
    if (pictureFormatOf(path) == nullptr)
        throw Error(ErrorKind::usage, "--out",
                    Found("'" + path + "'")
                        .expected("a name that ends in .exr, .png, " + pictureExtensions()));
    requirePictureModule(ErrorKind::output, path);
}

void writeImage(const Image& image, const std::string& path, float exposure)
{
    checkImagePath(path);
    writeFile(path, fileOf(image, path, exposure));
}

}  // namespace fbrdf::scene

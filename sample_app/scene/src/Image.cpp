#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/base/Srgb.h>
#include <fbrdf/codecs/PictureFile.h>
#include <fbrdf/pictures/Exr.h>
#include <fbrdf/pictures/Png.h>
#include <fbrdf/scene/Image.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

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

/// How radiance becomes what sRGB codes stand for.
struct Exposing {
    float exposure;
    Transfer transfer;

    float operator()(float linear) const
    {
        const float exposed = exposure * linear;
        return transfer == Transfer::toneMap ? toneMapped(exposed) : exposed;
    }
};

std::string pngOf(const Image& image, const std::string& path, const Exposing& exposed)
{
    const std::vector<uint8_t> codes = srgbCodes(image, exposed.exposure, exposed.transfer);
    return encodePng({image.width, image.height, 3, 8, {codes.begin(), codes.end()}}, path);
}

float srgbSample(float exposed)
{
    return exposed > 0.0f ? static_cast<float>(srgbFromLinear(double(exposed))) : 0.0f;
}

/// Pictures of formats that a module writes; none of them has coverage.
std::string pictureOf(const Image& image, const PictureFormat& format, const std::string& path,
                      const Exposing& exposed)
{
    const bool isLinear = format.encoding == PictureEncoding::linear;
    PictureSamples picture{image.width, image.height, 3, {}};
    picture.samples.reserve(3 * image.pixelCount());
    for (size_t i = 0; i < image.rgba.size(); i += 4)
        for (size_t c = 0; c < 3; ++c)
            picture.samples.push_back(isLinear ? image.rgba[i + c]
                                               : srgbSample(exposed(image.rgba[i + c])));
    return encodePicture(picture, format, path);
}

}  // namespace

void add(const Image& image, Image& sum)
{
    FBRDF_ASSERT(image.rgba.size(), ==, sum.rgba.size());
    std::transform(image.rgba.begin(), image.rgba.end(), sum.rgba.begin(), sum.rgba.begin(),
                   std::plus<>());
}

Image meanOf(Image sum, int count)
{
    for (float& value : sum.rgba) value /= static_cast<float>(count);
    return sum;
}

uint8_t srgbCode(float linear)
{
    if (!(linear > 0.0f)) return 0;
    return static_cast<uint8_t>(std::lround(255.0 * srgbFromLinear(double(linear))));
}

std::vector<uint8_t> srgbCodes(const Image& image, float exposure, Transfer transfer)
{
    const Exposing exposed{exposure, transfer};
    std::vector<uint8_t> codes;
    codes.reserve(3 * image.pixelCount());
    for (size_t i = 0; i < image.rgba.size(); i += 4)
        for (size_t c = 0; c < 3; ++c) codes.push_back(srgbCode(exposed(image.rgba[i + c])));
    return codes;
}

std::string encodeImage(const Image& image, const std::string& path, float exposure,
                        Transfer transfer)
{
    const std::string extension = extensionOf(path);
    if (extension == ".exr") return exrOf(image, path);
    const Exposing exposed{exposure, transfer};
    if (extension == ".png") return pngOf(image, path, exposed);
    return pictureOf(image, *pictureFormatOf(path), path, exposed);
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

void writeImage(const Image& image, const std::string& path, float exposure, Transfer transfer)
{
    checkImagePath(path);
    writeFile(path, encodeImage(image, path, exposure, transfer));
}

}  // namespace fbrdf::scene

#include "PanoramaPicture.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Srgb.h>
#include <fbrdf/brdf/Half.h>
#include <fbrdf/environment/Sky.h>

#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>

namespace osgFbrdf {
namespace {

constexpr float kLargestHalf = 65504.0f;
// A comment may be long, but not so long.
constexpr size_t kMostHeaderBytes = 65536;

[[noreturn]] void refuse(const std::string& where, const std::string& what)
{
    throw fbrdf::Error(fbrdf::ErrorKind::input, where, what);
}

template <class T>
T valueAt(const unsigned char* row, int index)
{
    T value;
    std::memcpy(&value, row + static_cast<size_t>(index) * sizeof(T), sizeof(T));
    return value;
}

/// Channel `index` of a row: radiance, or an sRGB code where samples are integers.
float sampleAt(const unsigned char* row, GLenum type, int index)
{
    switch (type) {
        case GL_FLOAT: return valueAt<float>(row, index);
        case GL_HALF_FLOAT: return fbrdf::floatFromHalf(valueAt<uint16_t>(row, index));
        case GL_UNSIGNED_SHORT:
            return fbrdf::linearFromSrgb(static_cast<float>(valueAt<uint16_t>(row, index)) /
                                         65535.0f);
        default: return fbrdf::linearFromSrgb(static_cast<float>(row[index]) / 255.0f);
    }
}

/// Where red, green and blue are among the channels.
struct Channels {
    int count, red, green, blue;
};

Channels channelsOf(const osg::Image& picture, const std::string& where)
{
    switch (picture.getPixelFormat()) {
        case GL_LUMINANCE:
        case GL_RED: return {1, 0, 0, 0};
        case GL_LUMINANCE_ALPHA: return {2, 0, 0, 0};
        case GL_RGB: return {3, 0, 1, 2};
        case GL_BGR: return {3, 2, 1, 0};
        case GL_RGBA: return {4, 0, 1, 2};
        case GL_BGRA: return {4, 2, 1, 0};
        default: refuse(where, fbrdf::Found("pixels of another format").expected("RGB or grey"));
    }
}

void checkPicture(const osg::Image& picture, const std::string& where)
{
    if (!picture.data() || picture.s() < 1 || picture.r() != 1 || picture.s() != 2 * picture.t())
        refuse(where, fbrdf::Found("a picture of " + std::to_string(picture.s()) + " x " +
                                   std::to_string(picture.t()) + " pixels")
                          .expected("latitude and longitude: twice as wide as high"));
    const GLenum type = picture.getDataType();
    if (picture.isCompressed() || (type != GL_FLOAT && type != GL_HALF_FLOAT &&
                                   type != GL_UNSIGNED_SHORT && type != GL_UNSIGNED_BYTE))
        refuse(where, fbrdf::Found("samples of another type")
                          .expected("floats, halves, or integers of 8 or 16 bits"));
}

/// Negative values and those that are none count as 0, infinite ones as the largest half.
float repaired(float radiance)
{
    return radiance > 0.0f ? (std::isinf(radiance) ? kLargestHalf : radiance) : 0.0f;
}

/// OSG 3.6.5 reads on for ever where the header of a Radiance file does not end.
bool hasRadianceHeader(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::string header(kMostHeaderBytes, '\0');
    file.read(header.data(), static_cast<std::streamsize>(header.size()));
    header.resize(static_cast<size_t>(file.gcount()));
    const size_t end = header.find("\n\n-Y ");
    return end != std::string::npos && header.find('\n', end + 2) != std::string::npos;
}

}  // namespace

fbrdf::Panorama panoramaOf(const osg::Image& picture, const std::string& where, int mostColumns)
{
    checkPicture(picture, where);
    const Channels channels = channelsOf(picture, where);
    fbrdf::Panorama panorama{picture.s(), picture.t(), {}};
    panorama.texels.reserve(static_cast<size_t>(panorama.width) *
                            static_cast<size_t>(panorama.height));
    const bool topFirst = picture.getOrigin() == osg::Image::TOP_LEFT;
    for (int y = 0; y < panorama.height; ++y) {
        const auto line = static_cast<unsigned int>(topFirst ? y : panorama.height - 1 - y);
        const unsigned char* row = picture.data(0, line);
        const auto sample = [&](int x, int channel) {
            return repaired(sampleAt(row, picture.getDataType(), x * channels.count + channel));
        };
        for (int x = 0; x < panorama.width; ++x)
            panorama.texels.emplace_back(sample(x, channels.red), sample(x, channels.green),
                                         sample(x, channels.blue));
    }
    return panorama.width > mostColumns ? fbrdf::reduced(panorama, mostColumns) : panorama;
}

fbrdf::Panorama readPanoramaPicture(const std::string& file, const osgDB::Options* options)
{
    if (fbrdf::isProceduralEnvironment(file)) return fbrdf::proceduralEnvironment(file);
    const std::string path = osgDB::findDataFile(file, options);
    std::string expected = "a picture";
    for (const std::string& name : fbrdf::proceduralEnvironments()) expected += ", " + name;
    if (path.empty()) refuse(file, fbrdf::Found("no such file").expected(expected));
    const bool isRadiance = osgDB::getLowerCaseFileExtension(path) == "hdr";
    if (isRadiance && !hasRadianceHeader(path))
        refuse(file, fbrdf::Found("a file of another kind").expected("Radiance HDR from the top"));
    auto result = osgDB::Registry::instance()->readImage(path, options);
    if (!result.validImage())
        refuse(file, fbrdf::Found("a file that no plugin of osgDB reads as a picture")
                         .expected("Radiance HDR, or another of which there is a plugin"));
    return panoramaOf(*result.getImage(), file);
}

}  // namespace osgFbrdf

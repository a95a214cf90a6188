// ExrTable.cpp - reflectance in OpenEXR images, read through OpenImageIO. Channels R, G, B or one
// (Y), linear, 1/sr without the cosine. What the pixels mean is said by the string attribute
// "fbrdf:layout", or else by the size:
//   "utia"     288 x 288: UTIA's grid (UtiaTable.h); line = light, column = view, as in the images
//              of that database. Any 288 x 288 image without the attribute.
//   "slice"    theta_h to the right and theta_d upwards, both 0 to 90 degrees over the image, at
//              phi_d = 90 degrees: the "image slices" of Burley 2012 ("Physically-Based Shading at
//              Disney"), theta_h = 0 at the left, theta_d = 0 at the bottom. Any other size.
//   "latlong"  tiles one above the other, each a view hemisphere for one incident direction: phi_o
//              to the right from 0 to 360 degrees, theta_o downwards from 0 to 90. The string
//              attribute "fbrdf:theta_i" lists the zenith angles of the tiles in degrees,
//              comma-separated, top first; wi is at azimuth 0, away from the surface like wo.
// Values are at pixel centres. A slice and a lat-long table hold isotropic materials and have
// samples only; a pixel of a lat-long tile weighs sin theta_o, its share of the sphere.
#include "Formats.h"
#include "formats/UtiaTable.h"
#include "SampleRow.h"
#include "Text.h"

#include <fbrdf/brdf/HalfDifference.h>

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr std::string_view kMagic("\x76\x2f\x31\x01", 4);
/// 4096 x 4096: far above any table, far below what a hostile header could ask for.
constexpr size_t kMostPixels = size_t(1) << 24;

struct Image {
    size_t width = 0, height = 0;
    std::vector<Vec3f> pixels;  ///< height x width, top line first
    std::string layout, angles;

    const Vec3f& at(size_t x, size_t y) const { return pixels[y * width + x]; }
};

std::unique_ptr<OIIO::ImageInput> openImage(const InputFile& file)
{
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("openexr");
    OIIO::ImageSpec spec;
    if (!input || !input->open(file.path(), spec)) {
        const std::string why = input ? input->geterror() : OIIO::geterror();
        throw inputError(file, "found an OpenEXR file that cannot be read: " + why);
    }
    return input;
}

void requireSize(const InputFile& file, const OIIO::ImageSpec& spec)
{
    const bool sensible = spec.width > 0 && spec.height > 0 && spec.depth == 1 &&
                          size_t(spec.width) * size_t(spec.height) <= kMostPixels;
    if (!sensible || (spec.nchannels != 1 && spec.nchannels < 3) || spec.nchannels > 64)
        throw inputError(file, "found " + std::to_string(spec.width) + " x " +
                                   std::to_string(spec.height) + " pixels of " +
                                   std::to_string(spec.nchannels) +
                                   " channels, expected up to 2^24 pixels of 1 or 3");
}

Image readImage(const InputFile& file)
{
    const std::unique_ptr<OIIO::ImageInput> input = openImage(file);
    const OIIO::ImageSpec& spec = input->spec();
    requireSize(file, spec);
    Image image;
    image.width = size_t(spec.width);
    image.height = size_t(spec.height);
    image.layout = std::string(spec.get_string_attribute("fbrdf:layout"));
    image.angles = std::string(spec.get_string_attribute("fbrdf:theta_i"));
    const int channels = std::min(spec.nchannels, 3);
    std::vector<float> values(image.width * image.height * size_t(channels));
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeFloat, values.data()))
        throw inputError(file, "found pixels that cannot be read: " + input->geterror());
    for (size_t i = 0; i < image.width * image.height; ++i) {
        const float* v = values.data() + i * size_t(channels);
        image.pixels.push_back(channels == 3 ? Vec3f(v[0], v[1], v[2]) : Vec3f(v[0]));
    }
    return image;
}

Source sourceOfSlice(const Image& image)
{
    Source source;
    for (size_t y = 0; y < image.height; ++y)
        for (size_t x = 0; x < image.width; ++x) {
            const double theta_h = (double(x) + 0.5) / double(image.width) * kPi / 2;
            const double theta_d = (1.0 - (double(y) + 0.5) / double(image.height)) * kPi / 2;
            const DirectionPair<double> pair =
                pairFromHalfDifference({theta_h, 0.0, theta_d, kPi / 2});
            addUnitRow({pair.wo, pair.wi, Vec3d(image.at(x, y))}, source.samples, source.report);
        }
    source.description = "OpenEXR slice over theta_h and theta_d, linear RGB, 1/sr";
    return source;
}

std::vector<double> tileAngles(const InputFile& file, const Image& image)
{
    std::vector<std::string_view> fields;
    splitFields(image.angles, ',', fields);
    std::vector<double> angles(fields.size());
    for (size_t i = 0; i < fields.size(); ++i)
        if (!parseNumber(fields[i], angles[i]))
            throw inputError(file, "found fbrdf:theta_i " + quoted(image.angles) +
                                       ", expected zenith angles in degrees");
    if (image.height % angles.size() != 0)
        throw inputError(file, "found " + std::to_string(image.height) + " lines, expected " +
                                   std::to_string(angles.size()) + " tiles of equal height");
    return angles;
}

Source sourceOfLatLong(const InputFile& file, const Image& image)
{
    const std::vector<double> angles = tileAngles(file, image);
    const size_t lines = image.height / angles.size();
    Source source;
    for (size_t y = 0; y < image.height; ++y)
        for (size_t x = 0; x < image.width; ++x) {
            const double theta = (double(y % lines) + 0.5) / double(lines) * kPi / 2;
            const double phi = (double(x) + 0.5) / double(image.width) * 2 * kPi;
            addRow({directionFromAngles(theta, phi), directionFromDegrees(angles[y / lines], 0.0),
                    Vec3d(image.at(x, y)), std::sin(theta)},
                   source.samples, source.report);
        }
    source.description = "OpenEXR lat-long tables of " + std::to_string(angles.size()) +
                         " incident angles, linear RGB, 1/sr";
    return source;
}

Source sourceOfUtia(const InputFile& file, Image image)
{
    if (image.width != kUtiaSide || image.height != kUtiaSide)
        throw inputError(file, "found layout utia on " + std::to_string(image.width) + " x " +
                                   std::to_string(image.height) + " pixels, expected 288 x 288");
    return makeUtiaSource(std::move(image.pixels));
}

std::string layoutOf(const Image& image)
{
    if (!image.layout.empty()) return image.layout;
    return image.width == kUtiaSide && image.height == kUtiaSide ? "utia" : "slice";
}

}  // namespace

bool isExrTable(const InputFile& file)
{
    return file.bytes().substr(0, kMagic.size()) == kMagic;
}

Source readExrTable(const FileRequest& request)
{
    const InputFile& file = *request.file;
    if (!isExrTable(file)) throw inputError(file, 0, "found no OpenEXR magic number, expected it");
    Image image = readImage(file);
    const std::string layout = layoutOf(image);
    if (layout == "utia") return sourceOfUtia(file, std::move(image));
    if (layout != "slice" && layout != "latlong")
        throw inputError(
            file, "found fbrdf:layout " + quoted(layout) + ", expected utia, slice or latlong");
    Source source = layout == "slice" ? sourceOfSlice(image) : sourceOfLatLong(file, image);
    source.isotropic = true;
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf

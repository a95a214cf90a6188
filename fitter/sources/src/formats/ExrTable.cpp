// ExrTable.cpp - reflectance in OpenEXR images of any compression, scan lines or tiles. Channels R,
// G, B (of a layer, too: "diffuse.R") or a single one, linear, 1/sr without the cosine. The string
// attribute "fbrdf:layout" gives the meaning of the pixels; where it is missing, their number does:
//   "utia"     288 x 288: UTIA's grid (UtiaTable.h); line = light, column = view, as in the images
//              of that database. Any 288 x 288 image without the attribute.
//   "slice"    theta_h to the right and theta_d upwards, both 0 to 90 degrees over the image, at
//              phi_d = 90 degrees: the "image slices" of Burley 2012 ("Physically-Based Shading at
//              Disney"), theta_h = 0 at the left, theta_d = 0 at the bottom. Any other size.
//   "latlong"  tiles one above the other, each a view hemisphere for one incident direction: phi_o
//              to the right from 0 to 360 degrees, theta_o downwards from 0 to 90. The string
//              attribute "fbrdf:theta_i" lists the zenith angles of the tiles in degrees,
//              comma-separated, top first; wi is at azimuth 0, away from the surface like wo.
// Values are at pixel centres. Slices and lat-long tables are of isotropic materials and have
// samples only; a pixel of a lat-long tile weighs sin theta_o, its share of the sphere.
#include <fbrdf/base/Text.h>
#include "Formats.h"
#include "formats/ExrImage.h"
#include "formats/UtiaTable.h"
#include "SampleRow.h"

#include <fbrdf/brdf/HalfDifference.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

Source sourceOfSlice(const TableImage& image)
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

std::vector<double> tileAngles(const InputFile& file, const TableImage& image)
{
    std::vector<std::string_view> fields;
    splitFields(image.angles, ',', fields);
    std::vector<double> angles(fields.size());
    for (size_t i = 0; i < fields.size(); ++i)
        if (!parseNumber(fields[i], angles[i]))
            throw inputError(file, "found fbrdf:theta_i " + inQuotes(image.angles) +
                                       ", expected zenith angles in degrees");
    if (image.height % angles.size() != 0)
        throw inputError(file, "found " + std::to_string(image.height) + " lines, expected " +
                                   std::to_string(angles.size()) + " tiles of equal height");
    return angles;
}

Source sourceOfLatLong(const InputFile& file, const TableImage& image)
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

Source sourceOfUtia(const InputFile& file, TableImage image)
{
    if (image.width != kUtiaSide || image.height != kUtiaSide)
        throw inputError(file, "found layout utia on " + std::to_string(image.width) + " x " +
                                   std::to_string(image.height) + " pixels, expected 288 x 288");
    return makeUtiaSource(std::move(image.pixels));
}

std::string layoutOf(const TableImage& image)
{
    if (!image.layout.empty()) return image.layout;
    return image.width == kUtiaSide && image.height == kUtiaSide ? "utia" : "slice";
}

}  // namespace

bool isExrTable(const InputFile& file)
{
    return isExr(file);
}

Source readExrTable(const FileRequest& request)
{
    const InputFile& file = *request.file;
    if (!isExrTable(file)) throw inputError(file, 0, "found no OpenEXR magic number, expected it");
    TableImage image = readExrImage(file);
    const std::string layout = layoutOf(image);
    if (layout == "utia") return sourceOfUtia(file, std::move(image));
    if (layout != "slice" && layout != "latlong")
        throw inputError(
            file, "found fbrdf:layout " + inQuotes(layout) + ", expected utia, slice or latlong");
    Source source = layout == "slice" ? sourceOfSlice(image) : sourceOfLatLong(file, image);
    source.isotropic = true;
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf

#include "formats/ImageTable.h"

#include "formats/UtiaTable.h"
#include "SampleRow.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>
#include <fbrdf/brdf/HalfDifference.h>

#include <cmath>
#include <memory>
#include <utility>

namespace fbrdf {
namespace {

using SharedImage = std::shared_ptr<const TableImage>;

/// A row for each pixel, made by `rowAt(x, y)` when it is asked for.
template <class RowAt>
SampleStream streamOfPixels(const SharedImage& image, RowAt rowAt)
{
    SampleStream stream;
    stream.rows = image->pixels.size();
    stream.read = [image, rowAt](uint64_t first, size_t count, std::vector<Sample>& samples,
                                 SampleReport& report) {
        for (size_t i = size_t(first); i < size_t(first) + count; ++i)
            addRow(rowAt(*image, i % image->width, i / image->width), samples, report);
    };
    return stream;
}

Source sourceOfSlice(const SharedImage& image)
{
    Source source;
    source.stream = streamOfPixels(image, [](const TableImage& pixels, size_t x, size_t y) {
        const double theta_h = (double(x) + 0.5) / double(pixels.width) * kPi / 2;
        const double theta_d = (1.0 - (double(y) + 0.5) / double(pixels.height)) * kPi / 2;
        const DirectionPair<double> pair = pairFromHalfDifference({theta_h, 0.0, theta_d, kPi / 2});
        return SampleRow{pair.wo, pair.wi, Vec3d(pixels.at(x, y))};
    });
    source.description = "slice over theta_h and theta_d, linear RGB, 1/sr";
    return source;
}

std::vector<double> tileAngles(const InputFile& file, const TableImage& image)
{
    std::vector<std::string_view> fields;
    splitFields(image.angles, ',', fields);
    std::vector<double> angles(fields.size());
    for (size_t i = 0; i < fields.size(); ++i)
        if (!parseNumber(fields[i], angles[i]))
            throw inputError(file, Found("fbrdf:theta_i " + inQuotes(image.angles))
                                       .expected("zenith angles in degrees"));
    if (image.height % angles.size() != 0)
        throw inputError(file,
                         Found(std::to_string(image.height) + " lines")
                             .expected(std::to_string(angles.size()) + " tiles of equal height"));
    return angles;
}

Source sourceOfLatLong(const InputFile& file, const SharedImage& image)
{
    const std::vector<double> angles = tileAngles(file, *image);
    const size_t lines = image->height / angles.size();
    Source source;
    source.stream =
        streamOfPixels(image, [angles, lines](const TableImage& pixels, size_t x, size_t y) {
            const double theta = (double(y % lines) + 0.5) / double(lines) * kPi / 2;
            const double phi = (double(x) + 0.5) / double(pixels.width) * 2 * kPi;
            return SampleRow{directionFromAngles(theta, phi),
                             directionFromDegrees(angles[y / lines], 0.0), Vec3d(pixels.at(x, y)),
                             std::sin(theta)};
        });
    source.description = "lat-long tables of " + std::to_string(angles.size()) +
                         " incident angles, linear RGB, 1/sr";
    return source;
}

Source sourceOfUtia(const InputFile& file, TableImage image)
{
    if (image.width != kUtiaSide || image.height != kUtiaSide)
        throw inputError(file, Found("layout utia on " + std::to_string(image.width) + " x " +
                                     std::to_string(image.height) + " pixels")
                                   .expected("288 x 288"));
    return makeUtiaSource(std::move(image.pixels));
}

std::string layoutOf(const TableImage& image)
{
    if (!image.layout.empty()) return image.layout;
    return image.width == kUtiaSide && image.height == kUtiaSide ? "utia" : "slice";
}

}  // namespace

Source sourceOfImage(const InputFile& file, TableImage image, const std::string& format)
{
    const std::string layout = layoutOf(image);
    std::vector<std::string> assumptions = image.assumptions;
    if (image.layout.empty()) assumptions.push_back("the layout " + layout + ", by its size");
    if (layout == "utia") {
        Source source = sourceOfUtia(file, std::move(image));
        source.assumptions.insert(source.assumptions.end(), assumptions.begin(), assumptions.end());
        return source;
    }
    if (layout != "slice" && layout != "latlong")
        throw inputError(
            file, Found("fbrdf:layout " + inQuotes(layout)).expected("utia, slice or latlong"));
    const auto shared = std::make_shared<const TableImage>(std::move(image));
    Source source = layout == "slice" ? sourceOfSlice(shared) : sourceOfLatLong(file, shared);
    source.description = format + " " + source.description;
    source.isotropic = true;
    source.assumptions = assumptions;
    requireSamples(source, file.path());
    return source;
}

}  // namespace fbrdf

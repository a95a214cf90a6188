// PictureTable.cpp - reflectance in TIFF and Radiance HDR images, as slices over theta_h and
// theta_d or, of 288 x 288 pixels, as UTIA's grid (ImageTable.h). Samples are floating point and
// linear: integers in [0, 1] with the curve of a display are pictures of a material, not its
// values.
#include "Formats.h"
#include "formats/ImageTable.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/codecs/PictureFile.h>

#include <algorithm>
#include <array>

namespace fbrdf {
namespace {

/// What OpenImageIO calls the format that a file begins like, or "".
const char* codecOf(const InputFile& file)
{
    using namespace std::string_view_literals;
    const auto begins = [&](std::string_view mark) {
        return file.bytes().substr(0, mark.size()) == mark;
    };
    // Little and big endian, and both of BigTIFF.
    for (const std::string_view mark : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv})
        if (begins(mark)) return "tiff";
    return begins("#?RADIANCE") || begins("#?RGBE") ? "hdr" : "";
}

void requireLinear(const InputFile& file, const DecodedPicture& picture)
{
    if (picture.sampleType != "float" && picture.sampleType != "half" &&
        picture.sampleType != "double")
        throw inputError(file, Found("samples of type " + picture.sampleType)
                                   .expected("floating point, linear values in 1/sr"));
    if (picture.colourSpace == "sRGB")
        throw inputError(file,
                         Found("colours encoded for a display (sRGB)").expected("linear values"));
}

/// Where red, green and blue are among the channels; thrice 0 for a single one.
std::array<size_t, 3> coloursOf(const InputFile& file, const DecodedPicture& picture)
{
    std::array<size_t, 3> places{};
    if (picture.channels.size() == 1) return places;
    const char* const names[] = {"R", "G", "B"};
    for (size_t c = 0; c < 3; ++c) {
        const auto& all = picture.channels;
        const auto found = std::find(all.begin(), all.end(), names[c]);
        if (found == all.end())
            throw inputError(file,
                             Found(std::to_string(all.size()) + " channels without " + names[c])
                                 .expected("R, G, B or a single one"));
        places[c] = static_cast<size_t>(found - all.begin());
    }
    return places;
}

TableImage tableOf(const InputFile& file, const DecodedPicture& picture)
{
    const std::array<size_t, 3> colours = coloursOf(file, picture);
    TableImage image;
    image.width = static_cast<size_t>(picture.width);
    image.height = static_cast<size_t>(picture.height);
    image.pixels.reserve(image.width * image.height);
    for (size_t i = 0; i < picture.samples.size(); i += picture.channels.size())
        image.pixels.emplace_back(picture.samples[i + colours[0]], picture.samples[i + colours[1]],
                                  picture.samples[i + colours[2]]);
    return image;
}

}  // namespace

bool isPictureTable(const InputFile& file)
{
    return *codecOf(file) != '\0';
}

Source readPictureTable(const FileRequest& request)
{
    const InputFile& file = *request.file;
    if (!isPictureTable(file))
        throw inputError(file, 0, Found("neither TIFF nor Radiance HDR").expected("one of them"));
    const std::string codec = codecOf(file);
    const DecodedPicture picture =
        decodePicture(file.bytes(), codec.c_str(), file.path(),
                      [&](const DecodedPicture& header) { requireLinear(file, header); });
    Source source =
        sourceOfImage(file, tableOf(file, picture), codec == "tiff" ? "TIFF" : "Radiance HDR");
    source.assumptions.emplace_back("linear values in 1/sr without the cosine");
    return source;
}

}  // namespace fbrdf

#include "LightPicture.h"

#include "ExrHeader.h"
#include "Module.h"
#include "PictureModule.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Srgb.h>
#include <fbrdf/pictures/Png.h>

#include <algorithm>
#include <array>
#include <exception>
#include <optional>

namespace fbrdf {
namespace {

constexpr const char* kSrgbNote = "; sRGB, so that no light is above 1";
constexpr size_t kReasonLength = 512;
/// A row of tiles is decoded at once; wider or higher ones than published are taken for damage.
constexpr int64_t kMostTileRowPixels = int64_t(1) << 23;
constexpr int64_t kLeastCoverage = 16, kMostCoverage = 4;

/// Channels of a part that are red, green and blue, or three times the same.
using Colours = std::array<int, 3>;

std::vector<std::string> channelsOf(const std::string& names)
{
    std::vector<std::string> all(1);
    for (const char c : names) {
        if (c == ',')
            all.emplace_back();
        else
            all.back() += c;
    }
    return all;
}

/// "layer.R" is "layer." and "r".
struct ChannelName {
    std::string layer, last;
};

ChannelName nameOf(const std::string& channel)
{
    const size_t dot = channel.rfind('.');
    const size_t begin = dot == std::string::npos ? 0 : dot + 1;
    std::string last = channel.substr(begin);
    for (char& c : last)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return {channel.substr(0, begin), last};
}

int find(const std::vector<std::string>& channels, const std::string& layer, const char* shortName,
         const char* longName)
{
    for (size_t i = 0; i < channels.size(); ++i) {
        const ChannelName name = nameOf(channels[i]);
        if (name.layer == layer && (name.last == shortName || name.last == longName))
            return static_cast<int>(i);
    }
    return -1;
}

std::optional<Colours> coloursOfLayer(const std::vector<std::string>& channels,
                                      const std::string& layer)
{
    const Colours rgb = {find(channels, layer, "r", "red"), find(channels, layer, "g", "green"),
                         find(channels, layer, "b", "blue")};
    if (rgb[0] >= 0 && rgb[1] >= 0 && rgb[2] >= 0) return rgb;
    const int grey = find(channels, layer, "y", "l");
    if (grey < 0 || find(channels, layer, "ry", "by") >= 0) return std::nullopt;
    return Colours{grey, grey, grey};
}

/// Those without a layer, else of the first layer that has colours.
std::optional<Colours> coloursOfPart(const std::vector<std::string>& channels)
{
    if (const auto plain = coloursOfLayer(channels, "")) return plain;
    for (const std::string& channel : channels)
        if (const auto layered = coloursOfLayer(channels, nameOf(channel).layer)) return layered;
    return std::nullopt;
}

/// What the functions that the module calls need to know and find out.
struct RowDecoding {
    const std::string& where;
    size_t bytes;  ///< of the file
    std::optional<LightRows> rows;
    Colours colours{};
    int channels = 0;  ///< that are decoded
    fbrdf_picture_part part{};
    bool isEncoded = false;  ///< by the curve of sRGB
    float unit = 1.0f;       ///< what a decoded sample of 1 stands for
    std::string layer;
    std::string seen;            ///< channels of parts that were passed over
    std::exception_ptr refusal;  ///< why the picture was refused; null if it was not
};

void requireTiles(const RowDecoding& decoding, const fbrdf_picture_part& part)
{
    if (part.isTiled != 0 && int64_t(part.tileHeight) * part.found.width > kMostTileRowPixels)
        throw Error(ErrorKind::input, decoding.where,
                    Found("tiles of " + std::to_string(part.tileWidth) + " x " +
                          std::to_string(part.tileHeight) + " pixels")
                        .expected("smaller ones (oiiotool IN --scanline -o OUT)"));
}

/// A file of some bytes could promise a black picture of any size, or rows that nobody needs.
void requireCoverage(const RowDecoding& decoding, const fbrdf_picture_part& part)
{
    const int64_t stored = int64_t(part.found.width) * part.found.height,
                  whole = int64_t(part.pictureWidth) * part.pictureHeight;
    if (!mayHavePixels(std::max(stored, whole), decoding.bytes))
        throw Error(
            ErrorKind::input, decoding.where,
            Found(std::to_string(part.pictureWidth) + " x " + std::to_string(part.pictureHeight) +
                  " pixels in " + std::to_string(decoding.bytes) + " bytes")
                .expected("not far more pixels than bytes"));
    if (kLeastCoverage * stored < whole || stored > kMostCoverage * whole)
        throw Error(
            ErrorKind::input, decoding.where,
            Found("data of " + std::to_string(part.found.width) + " x " +
                  std::to_string(part.found.height) + " pixels in a picture of " +
                  std::to_string(part.pictureWidth) + " x " + std::to_string(part.pictureHeight))
                .expected("data for a sixteenth to four times of it"));
}

int choose(RowDecoding& decoding, const fbrdf_picture_part& part, int& firstChannel)
{
    const std::vector<std::string> channels = channelsOf(part.found.channelNames);
    const auto colours = coloursOfPart(channels);
    if (!colours) {
        decoding.seen += (decoding.seen.empty() ? "" : ";") + std::string(part.found.channelNames);
        return 0;
    }
    requireTiles(decoding, part);
    requireCoverage(decoding, part);
    const auto [least, most] = std::minmax_element(colours->begin(), colours->end());
    firstChannel = *least;
    decoding.channels = *most - *least + 1;
    for (size_t c = 0; c < 3; ++c) decoding.colours[c] = (*colours)[c] - firstChannel;
    decoding.layer = nameOf(channels[static_cast<size_t>(firstChannel)]).layer;
    decoding.part = part;
    const std::string type = part.found.sampleType;
    decoding.isEncoded = type == "uint8" || type == "uint16";
    // Those of OpenEXR are numbers like the others; the module has divided them by the largest.
    if (type == "uint") decoding.unit = 4294967295.0f;
    decoding.rows.emplace(part.pictureWidth, part.pictureHeight, decoding.where);
    for (int y = 0; y < std::min(part.y, part.pictureHeight); ++y)
        decoding.rows->add(std::vector<Vec3f>(static_cast<size_t>(part.pictureWidth)));
    return decoding.channels;
}

int chooseOfModule(void* context, const fbrdf_picture_part* part, int* firstChannel)
{
    auto& decoding = *static_cast<RowDecoding*>(context);
    try {
        return choose(decoding, *part, *firstChannel);
    } catch (...) {  // no exception crosses the module
        decoding.refusal = std::current_exception();
        return -1;
    }
}

/// One stored row at its place in the row of the picture.
std::vector<Vec3f> rowOf(const RowDecoding& decoding, const float* pixels)
{
    std::vector<Vec3f> row(static_cast<size_t>(decoding.part.pictureWidth));
    for (int x = 0; x < decoding.part.found.width; ++x, pixels += decoding.channels) {
        const int at = x + decoding.part.x;
        if (at < 0 || at >= decoding.part.pictureWidth) continue;
        for (int c = 0; c < 3; ++c) {
            const float value = pixels[decoding.colours[static_cast<size_t>(c)]];
            row[static_cast<size_t>(at)][c] =
                decoding.isEncoded ? linearFromSrgb(value) : decoding.unit * value;
        }
    }
    return row;
}

int takeOfModule(void* context, const float* pixels, int rows)
{
    auto& decoding = *static_cast<RowDecoding*>(context);
    try {
        fbrdf_picture_part& part = decoding.part;
        for (int i = 0; i < rows; ++i, ++part.y) {
            if (part.y >= 0 && part.y < part.pictureHeight)
                decoding.rows->add(rowOf(decoding, pixels));
            pixels += std::ptrdiff_t(part.found.width) * decoding.channels;
        }
        return 0;
    } catch (...) {
        decoding.refusal = std::current_exception();
        return -1;
    }
}

/// OpenImageIO's reader of PNG writes to stderr; ours does not.
LightPicture decodePngLight(const std::string& bytes, const std::string& where)
{
    const PngImage image = decodePng(bytes, where);
    LightRows rows(image.width, image.height, where);
    const float unit = image.bits == 8 ? 1.0f / 255.0f : 1.0f / 65535.0f;
    const auto channels = static_cast<size_t>(image.channels);
    const uint16_t* code = image.codes.data();
    std::vector<Vec3f> row(static_cast<size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        for (Vec3f& texel : row) {
            for (size_t c = 0; c < 3; ++c)
                texel[static_cast<int>(c)] =
                    linearFromSrgb(unit * static_cast<float>(code[channels < 3 ? 0 : c]));
            code += channels;
        }
        rows.add(row);
    }
    LightPicture picture = rows.picture();
    picture.notes += kSrgbNote;
    return picture;
}

}  // namespace

LightPicture decodeLightPicture(const std::string& bytes, const char* format,
                                const std::string& where)
{
    if (std::string(format) == "png") return decodePngLight(bytes, where);
    if (std::string(format) == "openexr") requireSensibleExr(bytes, where);
    const fbrdf_picture_module& module = pictureModule(ErrorKind::input, where);
    RowDecoding decoding{where, bytes.size(), {}, {}, 0, {}, false, 1.0f, "", "", nullptr};
    char why[kReasonLength] = "";
    if (module.decodeRows(format, bytes.data(), bytes.size(), chooseOfModule, takeOfModule,
                          &decoding, why, sizeof why) != 0) {
        if (decoding.refusal) std::rethrow_exception(decoding.refusal);
        if (!decoding.rows && !decoding.seen.empty())
            throw Error(ErrorKind::input, where,
                        Found("channels " + decoding.seen).expected("R, G and B, or Y alone"));
        throw Error(ErrorKind::input, where,
                    Found(std::string("a picture that cannot be read (") + why + ")")
                        .expected(std::string("a whole ") + format + " file"));
    }
    // Rows below what the file stores.
    for (int y = std::max(decoding.part.y, 0); y < decoding.part.pictureHeight; ++y)
        decoding.rows->add(std::vector<Vec3f>(static_cast<size_t>(decoding.part.pictureWidth)));
    LightPicture picture = decoding.rows->picture();
    if (!decoding.layer.empty()) picture.notes += "; layer " + decoding.layer;
    if (decoding.isEncoded) picture.notes += kSrgbNote;
    return picture;
}

}  // namespace fbrdf

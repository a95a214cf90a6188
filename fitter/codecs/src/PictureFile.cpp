#include "Module.h"
#include "PictureModule.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/codecs/PictureFile.h>

#include <algorithm>
#include <filesystem>

namespace fbrdf {
namespace {

constexpr PictureFormat kFormats[] = {
    {".bmp", "bmp", PictureEncoding::srgb8},    {".gif", "gif", PictureEncoding::srgb8},
    {".hdr", "hdr", PictureEncoding::linear},   {".jpeg", "jpeg", PictureEncoding::srgb8},
    {".jpg", "jpeg", PictureEncoding::srgb8},   {".ppm", "pnm", PictureEncoding::srgb8},
    {".tga", "targa", PictureEncoding::srgb8},  {".tif", "tiff", PictureEncoding::srgb16},
    {".tiff", "tiff", PictureEncoding::srgb16}, {".webp", "webp", PictureEncoding::srgb8},
};

/// 4096 x 4096, as for OpenEXR tables.
constexpr int64_t kMostPixels = int64_t(1) << 24;
/// Samples may take this much more memory than the bytes of their file, beside 12 MiB: 2^20 pixels
/// of R, G, B. While grey ones become colours four times as much is in use, and readers take no
/// more than 16 times a file beside 64 MiB.
constexpr size_t kMostRatio = 4, kAlwaysAllowed = size_t(12) << 20;
constexpr size_t kReasonSize = 512;

int bitsOf(PictureEncoding encoding)
{
    switch (encoding) {
        case PictureEncoding::srgb8: return 8;
        case PictureEncoding::srgb16: return 16;
        case PictureEncoding::linear: return 32;
    }
    return 0;
}

void appendBytes(void* file, const void* bytes, size_t size)
{
    static_cast<std::string*>(file)->assign(static_cast<const char*>(bytes), size);
}

/// What `giveMemory` needs to know and finds out.
struct Decoding {
    size_t fileSize;
    const std::string& where;
    const PictureCheck& check;
    DecodedPicture picture;
    std::exception_ptr refusal;  ///< why the picture was refused; null if it was not
};

bool isSensible(const fbrdf_picture_found& found, size_t fileSize)
{
    if (found.width < 1 || found.height < 1 || found.channels < 1) return false;
    if (int64_t(found.width) * found.height > kMostPixels) return false;
    const size_t samples =
        size_t(found.width) * size_t(found.height) * static_cast<size_t>(found.channels);
    return samples * sizeof(float) <= kMostRatio * fileSize + kAlwaysAllowed;
}

std::vector<std::string> namesOf(const std::string& joined)
{
    std::vector<std::string> names(1);
    for (const char c : joined) {
        if (c == ',')
            names.emplace_back();
        else
            names.back() += c;
    }
    return names;
}

void fillPicture(const fbrdf_picture_found& found, Decoding& decoding)
{
    if (!isSensible(found, decoding.fileSize))
        throw Error(ErrorKind::input, decoding.where,
                    Found(std::to_string(found.width) + " x " + std::to_string(found.height) +
                          " pixels of " + std::to_string(found.channels) + " channels in " +
                          std::to_string(decoding.fileSize) + " bytes")
                        .expected("up to 2^24 pixels and far fewer in a small file"));
    DecodedPicture& picture = decoding.picture;
    picture.width = found.width;
    picture.height = found.height;
    picture.channels = namesOf(found.channelNames);
    picture.channels.resize(static_cast<size_t>(found.channels));
    picture.colourSpace = found.colourSpace;
    picture.sampleType = found.sampleType;
    if (decoding.check) decoding.check(picture);
    picture.samples.resize(size_t(found.width) * size_t(found.height) * picture.channels.size());
}

float* giveMemory(void* context, const fbrdf_picture_found* found)
{
    auto& decoding = *static_cast<Decoding*>(context);
    try {
        fillPicture(*found, decoding);
        return decoding.picture.samples.data();
    } catch (...) {  // no exception crosses the module, but decodePicture throws it again
        decoding.refusal = std::current_exception();
        return nullptr;
    }
}

}  // namespace

const PictureFormat* pictureFormatOf(const std::string& path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const auto* const end = std::end(kFormats);
    const auto* const found = std::find_if(std::begin(kFormats), end, [&](const auto& format) {
        return extension == format.extension;
    });
    return found == end ? nullptr : found;
}

std::string pictureExtensions()
{
    std::string all;
    for (const PictureFormat& format : kFormats)
        all += std::string(all.empty() ? "" : ", ") + format.extension;
    return all;
}

std::string encodePicture(const PictureSamples& picture, const PictureFormat& format,
                          const std::string& where)
{
    FBRDF_ASSERT(picture.samples.size(), ==,
                 size_t(picture.width) * size_t(picture.height) * size_t(picture.channels));
    const fbrdf_picture_module& module = pictureModule(ErrorKind::output, where);
    const bool linear = format.encoding == PictureEncoding::linear;
    const fbrdf_picture_to_write source{picture.width,           picture.height,
                                        picture.channels,        picture.samples.data(),
                                        bitsOf(format.encoding), linear ? "lin_rec709" : "sRGB"};
    std::string bytes;
    char why[kReasonSize] = "";
    if (module.encode(format.name, &source, appendBytes, &bytes, why, sizeof why) != 0)
        throw Error(ErrorKind::output, where, std::string("cannot be written: ") + why);
    return bytes;
}

DecodedPicture decodePicture(std::string_view bytes, const char* format, const std::string& where,
                             const PictureCheck& check)
{
    const fbrdf_picture_module& module = pictureModule(ErrorKind::input, where);
    Decoding decoding{bytes.size(), where, check, {}, nullptr};
    char why[kReasonSize] = "";
    if (module.decode(format, bytes.data(), bytes.size(), giveMemory, &decoding, why, sizeof why) !=
        0) {
        if (decoding.refusal) std::rethrow_exception(decoding.refusal);
        throw Error(ErrorKind::input, where,
                    Found(std::string("a picture that cannot be read (") + why + ")")
                        .expected(std::string("a whole ") + format + " file"));
    }
    return std::move(decoding.picture);
}

void requirePictureModule(ErrorKind kind, const std::string& where)
{
    pictureModule(kind, where);
}

}  // namespace fbrdf

// The module that links OpenImageIO. Everything goes through memory: the program writes files.
#include "PictureModule.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

/// JPEG without visible blocks, and with colours as fine as brightness.
constexpr const char* kJpegCompression = "jpeg:95";
constexpr const char* kJpegSubsampling = "4:4:4";
/// Far above any picture that the program takes, far below what a hostile header could ask for.
constexpr int kMostMegabytes = 4096, kMostChannels = 64;
/// A tile is decoded as a whole, however few of its pixels are of the picture.
constexpr int64_t kTileBytesOfAnyPicture = 1 << 22;
/// Rows that are decoded at once, and fewer where they are long: blocks of OpenEXR have 1 to 256,
/// and it keeps the last one.
constexpr int kRowsAtOnce = 64, kSamplesAtOnce = 1 << 22;

/// What a codec reports, as one line.
std::string oneLine(std::string text)
{
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
    return text.empty() ? "no reason is known" : text;
}

/// Runs `work` and turns what it throws into the reason.
template <class Work>
int guarded(char* why, size_t whySize, const Work& work)
{
    std::string reason;
    try {
        work();
        return 0;
    } catch (const std::exception& error) {
        reason = oneLine(error.what());
    } catch (...) {
        reason = "a codec failed";
    }
    if (whySize > 0) {
        const size_t kept = std::min(reason.size(), whySize - 1);
        std::memcpy(why, reason.data(), kept);
        why[kept] = '\0';
    }
    return 1;
}

template <class Codec>
void require(bool done, const Codec& codec)
{
    if (!done) throw std::runtime_error(codec->geterror());
}

OIIO::ImageSpec specOf(const char* format, const fbrdf_picture_to_write& picture)
{
    const OIIO::TypeDesc type = picture.bits == 32   ? OIIO::TypeDesc::FLOAT
                                : picture.bits == 16 ? OIIO::TypeDesc::UINT16
                                                     : OIIO::TypeDesc::UINT8;
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, type);
    const std::string name = format;
    // OpenImageIO 2.4 writes the attribute as EXIF, and TIFF with EXIF wrongly to memory (its pull
    // request 4300). Integer samples of TIFF are taken for sRGB anyway.
    if (name != "tiff") spec.attribute("oiio:ColorSpace", picture.colourSpace);
    if (name == "jpeg") {
        spec.attribute("compression", kJpegCompression);
        spec.attribute("jpeg:subsampling", kJpegSubsampling);
    }
    return spec;
}

std::vector<unsigned char> encoded(const char* format, const fbrdf_picture_to_write& picture)
{
    const auto output = OIIO::ImageOutput::create(format);
    if (!output) throw std::runtime_error(OIIO::geterror());
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput proxy(bytes);
    if (!output->supports("ioproxy") || !output->set_ioproxy(&proxy))
        throw std::runtime_error("this format cannot be written to memory");
    // The name says nothing but the format: no file of it is opened.
    require(output->open(std::string("memory.") + format, specOf(format, picture)), output);
    require(output->write_image(OIIO::TypeDesc::FLOAT, picture.pixels), output);
    require(output->close(), output);
    if (bytes.empty()) throw std::runtime_error("the codec wrote nothing");
    return bytes;
}

std::vector<unsigned char> encodedFrames(const char* format, const fbrdf_frames_to_write& frames)
{
    const auto output = OIIO::ImageOutput::create(format);
    if (!output) throw std::runtime_error(OIIO::geterror());
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput proxy(bytes);
    if (!output->supports("multiimage") || !output->set_ioproxy(&proxy))
        throw std::runtime_error("this format has no moving pictures in memory");
    OIIO::ImageSpec spec(frames.width, frames.height, 3, OIIO::TypeDesc::UINT8);
    const int rate[2] = {frames.framesPerSecond, 1};
    spec.attribute("FramesPerSecond", OIIO::TypeRational, rate);
    const std::vector<OIIO::ImageSpec> specs(static_cast<size_t>(frames.count), spec);
    const std::string name = std::string("memory.") + format;
    require(output->open(name, frames.count, specs.data()), output);
    for (int i = 0; i < frames.count; ++i) {
        if (i > 0) require(output->open(name, spec, OIIO::ImageOutput::AppendSubimage), output);
        require(output->write_image(OIIO::TypeDesc::UINT8, frames.frames[i]), output);
    }
    require(output->close(), output);
    return bytes;
}

std::string joined(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
    return text;
}

float* memoryFor(const OIIO::ImageSpec& spec, fbrdf_give_memory give, void* context)
{
    const std::string names = joined(spec.channelnames),
                      colours(spec.get_string_attribute("oiio:ColorSpace")),
                      type = spec.format.c_str();
    const fbrdf_picture_found found{spec.width,    spec.height,     spec.nchannels,
                                    names.c_str(), colours.c_str(), type.c_str()};
    float* memory = give(context, &found);
    if (memory == nullptr) throw std::runtime_error("the picture was refused");
    return memory;
}

void requireTiles(const OIIO::ImageSpec& spec)
{
    const auto bytes = static_cast<int64_t>(spec.pixel_bytes(true));
    const int64_t whole = int64_t(spec.width) * spec.height * bytes,
                  tile = int64_t(spec.tile_width) * spec.tile_height * bytes;
    if (tile > std::max(whole, kTileBytesOfAnyPicture))
        throw std::runtime_error("its tiles are larger than the picture");
}

std::unique_ptr<OIIO::ImageInput> opened(const char* format, OIIO::Filesystem::IOProxy& proxy)
{
    auto input = OIIO::ImageInput::create(format);
    if (!input) throw std::runtime_error(OIIO::geterror());
    if (!input->supports("ioproxy") || !input->set_ioproxy(&proxy))
        throw std::runtime_error("this format cannot be read from memory");
    OIIO::ImageSpec spec;
    require(input->open(std::string("memory.") + format, spec), input);
    return input;
}

void decode(const char* format, const void* bytes, size_t size, fbrdf_give_memory give,
            void* context)
{
    OIIO::Filesystem::IOMemReader proxy(const_cast<void*>(bytes), size);  // which only reads
    const auto input = opened(format, proxy);
    const OIIO::ImageSpec spec = input->spec();
    if (spec.deep || spec.depth > 1) throw std::runtime_error("it is no flat image");
    requireTiles(spec);
    float* pixels = memoryFor(spec, give, context);
    require(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels), input);
}

/// The part of a picture that an image of a file is, for `choose`.
struct Part {
    explicit Part(const OIIO::ImageSpec& spec)
        : names(joined(spec.channelnames)),
          colours(spec.get_string_attribute("oiio:ColorSpace")),
          type(spec.format.c_str()),
          plain{{spec.width, spec.height, spec.nchannels, names.c_str(), colours.c_str(),
                 type.c_str()},
                spec.x - spec.full_x,
                spec.y - spec.full_y,
                spec.full_width,
                spec.full_height,
                spec.tile_width > 0,
                spec.tile_width,
                spec.tile_height}
    {
    }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

    std::string names, colours, type;
    fbrdf_picture_part plain;
};

/// Channels of an image that are read.
struct Chosen {
    int image, first, count;
};

Chosen chosenPart(OIIO::ImageInput& input, fbrdf_choose_part choose, void* context)
{
    for (int image = 0; input.seek_subimage(image, 0); ++image) {
        const OIIO::ImageSpec& spec = input.spec();
        if (spec.deep || spec.depth > 1) continue;
        const Part part(spec);
        int first = 0;
        const int count = choose(context, &part.plain, &first);
        if (count < 0) throw std::runtime_error("the picture was refused");
        if (count > 0) return {image, first, count};
    }
    throw std::runtime_error("no image of the file is one that can be used");
}

void decodeRows(OIIO::ImageInput& input, const Chosen& chosen, fbrdf_take_rows take, void* context)
{
    const OIIO::ImageSpec spec = input.spec();
    const int few = std::max(1, kSamplesAtOnce / chosen.count / spec.width);
    const int step = spec.tile_width > 0 ? spec.tile_height : std::min(kRowsAtOnce, few);
    const int last = chosen.first + chosen.count, end = spec.y + spec.height;
    std::vector<float> pixels;
    for (int y = spec.y; y < end; y += step) {
        const int rows = std::min(step, end - y);
        pixels.resize(size_t(rows) * size_t(spec.width) * size_t(chosen.count));
        const bool done =
            spec.tile_width > 0
                ? input.read_tiles(chosen.image, 0, spec.x, spec.x + spec.width, y, y + rows,
                                   spec.z, spec.z + 1, chosen.first, last, OIIO::TypeDesc::FLOAT,
                                   pixels.data())
                : input.read_scanlines(chosen.image, 0, y, y + rows, spec.z, chosen.first, last,
                                       OIIO::TypeDesc::FLOAT, pixels.data());
        if (!done) throw std::runtime_error(input.geterror());
        if (take(context, pixels.data(), rows) != 0) throw std::runtime_error("it was refused");
    }
}

int decodePictureRows(const char* format, const void* bytes, size_t size, fbrdf_choose_part choose,
                      fbrdf_take_rows take, void* context, char* why, size_t whySize)
{
    return guarded(why, whySize, [&] {
        OIIO::Filesystem::IOMemReader proxy(const_cast<void*>(bytes), size);  // which only reads
        const auto input = opened(format, proxy);
        decodeRows(*input, chosenPart(*input, choose, context), take, context);
    });
}

int encodePicture(const char* format, const fbrdf_picture_to_write* picture, fbrdf_take_bytes take,
                  void* context, char* why, size_t whySize)
{
    return guarded(why, whySize, [&] {
        const std::vector<unsigned char> bytes = encoded(format, *picture);
        take(context, bytes.data(), bytes.size());
    });
}

int encodeFrames(const char* format, const fbrdf_frames_to_write* frames, fbrdf_take_bytes take,
                 void* context, char* why, size_t whySize)
{
    return guarded(why, whySize, [&] {
        const std::vector<unsigned char> bytes = encodedFrames(format, *frames);
        take(context, bytes.data(), bytes.size());
    });
}

int decodePicture(const char* format, const void* bytes, size_t size, fbrdf_give_memory give,
                  void* context, char* why, size_t whySize)
{
    return guarded(why, whySize, [&] { decode(format, bytes, size, give, context); });
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const fbrdf_picture_module*
fbrdf_open_picture_module()
{
    // One thread: the program has threads of its own, and its pictures are few.
    OIIO::attribute("threads", 1);
    OIIO::attribute("limits:imagesize_MB", kMostMegabytes);
    OIIO::attribute("limits:channels", kMostChannels);
    static constexpr fbrdf_picture_module module = {FBRDF_PICTURE_MODULE_VERSION, encodePicture,
                                                    decodePicture, decodePictureRows, encodeFrames};
    return &module;
}

// The module that links OpenImageIO. Everything goes through memory: the program writes files.
#include "PictureModule.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

/// JPEG without visible blocks, and with colours as fine as brightness.
constexpr const char* kJpegCompression = "jpeg:95";
constexpr const char* kJpegSubsampling = "4:4:4";
/// Far above any picture that the program takes, far below what a hostile header could ask for.
constexpr int kMostMegabytes = 1024, kMostChannels = 64;

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

void decode(const char* format, const void* bytes, size_t size, fbrdf_give_memory give,
            void* context)
{
    const auto input = OIIO::ImageInput::create(format);
    if (!input) throw std::runtime_error(OIIO::geterror());
    OIIO::Filesystem::IOMemReader proxy(const_cast<void*>(bytes), size);  // which only reads
    if (!input->supports("ioproxy") || !input->set_ioproxy(&proxy))
        throw std::runtime_error("this format cannot be read from memory");
    OIIO::ImageSpec spec;
    require(input->open(std::string("memory.") + format, spec), input);
    if (spec.deep || spec.depth > 1) throw std::runtime_error("it is no flat image");
    float* pixels = memoryFor(spec, give, context);
    require(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels), input);
}

int encodePicture(const char* format, const fbrdf_picture_to_write* picture, fbrdf_take_bytes take,
                  void* context, char* why, size_t whySize)
{
    return guarded(why, whySize, [&] {
        const std::vector<unsigned char> bytes = encoded(format, *picture);
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
                                                    decodePicture};
    return &module;
}

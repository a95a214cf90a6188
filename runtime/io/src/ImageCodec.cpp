#include "ImageCodec.h"

#include <fbrdf/brdf/Error.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>

namespace fbrdf {
namespace {

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;
namespace Filesystem = OIIO::Filesystem;

// OpenImageIO would write the present time: a fixed one keeps equal materials equal files.
constexpr char kFixedTime[] = "1970:01:01 00:00:00";
constexpr int kMaxPixels = 1 << 24;  // Form.cpp: no table has more texels
constexpr char kPngMagic[] = {'\x89', 'P', 'N', 'G', '\r', '\n', '\x1a', '\n'};

// Errors are taken from the object and from the thread, so that none is left for OpenImageIO to
// print at exit.
template <class Object>
std::string takeError(Object* object)
{
    std::string text = object ? object->geterror() : std::string();
    const std::string global = OIIO::geterror();
    if (text.empty()) text = global.empty() ? "unknown error of OpenImageIO" : global;
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

template <class Object>
[[noreturn]] void fail(ErrorKind kind, const std::string& where, Object* object)
{
    throw Error(kind, where, takeError(object));
}

void addValue(ImageSpec& spec, const ExrValue& value)
{
    switch (value.kind) {
        case ExrValue::Kind::text: spec.attribute(value.name, value.text); break;
        case ExrValue::Kind::integer: spec.attribute(value.name, value.integer); break;
        case ExrValue::Kind::integers:
            spec.attribute(value.name,
                           TypeDesc(TypeDesc::INT, static_cast<int>(value.integers.size())),
                           value.integers.data());
            break;
        case ExrValue::Kind::real: spec.attribute(value.name, TypeDesc::DOUBLE, &value.real); break;
        case ExrValue::Kind::floats:
            spec.attribute(value.name,
                           TypeDesc(TypeDesc::FLOAT, static_cast<int>(value.floats.size())),
                           value.floats.data());
            break;
    }
}

ImageSpec exrSpec(const ExrImage& image, int displayWidth, int displayHeight)
{
    ImageSpec spec(image.width, image.height, image.channels,
                   image.half ? TypeDesc::HALF : TypeDesc::FLOAT);
    spec.channelnames = image.channels == 1 ? std::vector<std::string>{"Y"}
                                            : std::vector<std::string>{"R", "G", "B"};
    spec.full_width = displayWidth;
    spec.full_height = displayHeight;
    spec.attribute("oiio:subimagename", image.name);
    spec.attribute("compression", "zip");
    spec.attribute("Software", "fbrdf " FBRDF_VERSION);
    spec.attribute("DateTime", kFixedTime);
    for (const ExrValue& value : image.values) addValue(spec, value);
    return spec;
}

std::vector<ImageSpec> exrSpecs(const std::vector<ExrImage>& images)
{
    int width = 1, height = 1;
    for (const ExrImage& image : images) {
        width = std::max(width, image.width);
        height = std::max(height, image.height);
    }
    std::vector<ImageSpec> specs;
    for (const ExrImage& image : images) specs.push_back(exrSpec(image, width, height));
    return specs;
}

std::unique_ptr<ImageInput> openMemory(const char* format, Filesystem::IOMemReader& reader,
                                       const std::string& where)
{
    auto input = ImageInput::create(format);
    ImageSpec spec, config;
    config["oiio:UnassociatedAlpha"] = 1;  // raw codes: nothing may be multiplied by alpha
    if (!input || !input->set_ioproxy(&reader) || !input->open(where, spec, config))
        fail(ErrorKind::input, where, input.get());
    return input;
}

}  // namespace

void writeExr(const std::string& path, const std::vector<ExrImage>& images,
              const std::string& where)
{
    const std::vector<ImageSpec> specs = exrSpecs(images);
    auto output = ImageOutput::create("openexr");
    if (!output || !output->open(path, static_cast<int>(specs.size()), specs.data()))
        fail(ErrorKind::output, where, output.get());
    for (size_t i = 0; i < images.size(); ++i) {
        if (i > 0 && !output->open(path, specs[i], ImageOutput::AppendSubimage))
            fail(ErrorKind::output, where, output.get());
        if (!output->write_image(TypeDesc::FLOAT, images[i].pixels.data()))
            fail(ErrorKind::output, where, output.get());
    }
    if (!output->close()) fail(ErrorKind::output, where, output.get());
}

std::vector<float> readExrPixels(const std::string& bytes, size_t part, const ExrPart& expected,
                                 const std::string& where)
{
    Filesystem::IOMemReader reader(const_cast<char*>(bytes.data()), bytes.size());
    const auto input = openMemory("openexr", reader, where);
    const int index = static_cast<int>(part);
    if (!input->seek_subimage(index, 0)) fail(ErrorKind::input, where, input.get());
    const ImageSpec& spec = input->spec();
    if (spec.width != expected.width || spec.height != expected.height ||
        spec.nchannels != expected.channels)
        throw Error(ErrorKind::input, where, "found a part that its header does not describe");
    std::vector<float> pixels(static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height) *
                              static_cast<size_t>(spec.nchannels));
    if (!input->read_image(index, 0, 0, spec.nchannels, TypeDesc::FLOAT, pixels.data()))
        fail(ErrorKind::input, where, input.get());
    return pixels;
}

std::string encodePng(const PngImage& image, const std::string& where)
{
    const bool wide = image.bits == 16;
    const ImageSpec spec(image.width, image.height, image.channels,
                         wide ? TypeDesc::UINT16 : TypeDesc::UINT8);
    std::vector<unsigned char> buffer;
    Filesystem::IOVecOutput writer(buffer);
    auto output = ImageOutput::create("png");
    if (!output || !output->set_ioproxy(&writer) || !output->open(where, spec))
        fail(ErrorKind::output, where, output.get());
    const std::vector<uint8_t> narrow(image.codes.begin(), image.codes.end());
    const bool written = wide ? output->write_image(TypeDesc::UINT16, image.codes.data())
                              : output->write_image(TypeDesc::UINT8, narrow.data());
    if (!written || !output->close()) fail(ErrorKind::output, where, output.get());
    return std::string(buffer.begin(), buffer.end());
}

PngImage decodePng(const std::string& bytes, const std::string& where)
{
    if (bytes.compare(0, sizeof kPngMagic, kPngMagic, sizeof kPngMagic) != 0)
        throw Error(ErrorKind::input, where, "found other first bytes, expected a PNG file");
    Filesystem::IOMemReader reader(const_cast<char*>(bytes.data()), bytes.size());
    const auto input = openMemory("png", reader, where);
    const ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.width > kMaxPixels / spec.height)
        throw Error(ErrorKind::input, where,
                    "found " + std::to_string(spec.width) + " x " + std::to_string(spec.height) +
                        " pixels, expected at most 2^24");
    if (spec.nchannels != 1 && spec.nchannels != 3)
        throw Error(ErrorKind::input, where,
                    "found " + std::to_string(spec.nchannels) + " channels, expected 1 or 3");
    PngImage image{spec.width, spec.height, spec.nchannels, 8, {}};
    const size_t count = static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height) *
                         static_cast<size_t>(spec.nchannels);
    std::vector<uint8_t> narrow(spec.format == TypeDesc::UINT16 ? 0 : count);
    image.bits = narrow.empty() ? 16 : 8;
    image.codes.resize(count);
    const bool read =
        image.bits == 16
            ? input->read_image(0, 0, 0, spec.nchannels, TypeDesc::UINT16, image.codes.data())
            : input->read_image(0, 0, 0, spec.nchannels, TypeDesc::UINT8, narrow.data());
    if (!read) fail(ErrorKind::input, where, input.get());
    std::copy(narrow.begin(), narrow.end(), image.codes.begin());
    return image;
}

}  // namespace fbrdf

#include "ExrCodec.h"

#include <fbrdf/base/Error.h>

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
    const auto input = ImageInput::create("openexr");
    ImageSpec first;
    if (!input || !input->set_ioproxy(&reader) || !input->open(where, first))
        fail(ErrorKind::input, where, input.get());
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

}  // namespace fbrdf

// Pixels come from OpenEXR's C++ library: its decoders of lossy compressions are older and more
// tested than those of the core library, which fbrdf::io uses for ZIP alone.
#include "formats/ExrImage.h"

#include <fbrdf/base/Text.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace fbrdf {
namespace {

constexpr std::string_view kExrMagic("\x76\x2f\x31\x01", 4);
/// Magic number and version come before the first attribute.
constexpr size_t kFirstAttribute = 8;
/// 4096 x 4096: far above any table, far below what a hostile header could ask for.
constexpr size_t kMostPixels = size_t(1) << 24;
/// Pixels may take this much more memory than their file, or 32 MiB: tables of one value compress
/// well, but a table of 1600 x 1600 texels is a large one.
constexpr size_t kMostRatio = 8, kAlwaysAllowed = size_t(32) << 20;

/// The file's bytes as OpenEXR reads them.
class MemoryStream : public Imf::IStream {
public:
    explicit MemoryStream(const InputFile& file)
        : IStream(file.path().c_str()), bytes_(file.bytes())
    {
    }
    bool read(char* to, int count) override
    {
        if (count < 0 || static_cast<uint64_t>(count) > bytes_.size() - position_)
            throw std::runtime_error("the file ends early");
        std::memcpy(to, bytes_.data() + position_, static_cast<size_t>(count));
        position_ += static_cast<size_t>(count);
        return position_ < bytes_.size();
    }
    uint64_t tellg() override { return position_; }
    void seekg(uint64_t position) override
    {
        if (position > bytes_.size()) throw std::runtime_error("an offset lies beyond the file");
        position_ = static_cast<size_t>(position);
    }

private:
    std::string_view bytes_;
    size_t position_ = 0;
};

/// One past the zero byte that ends the name at `position`.
size_t afterName(const InputFile& file, size_t position)
{
    const size_t end = file.bytes().find('\0', position);
    if (end == std::string_view::npos)
        throw inputError(file, position, "found the end of the file, expected a name");
    return end + 1;
}

// OpenEXR 3.1 takes memory for the size that an attribute claims before it reads the attribute.
void requireAttributesWithin(const InputFile& file)
{
    const std::string_view bytes = file.bytes();
    size_t at = kFirstAttribute;
    while (at < bytes.size() && bytes[at] != '\0') {
        at = afterName(file, afterName(file, at));
        uint32_t size = 0;
        if (bytes.size() - at < sizeof size)
            throw inputError(file, at, "found the end of the file, expected the size of a value");
        std::memcpy(&size, bytes.data() + at, sizeof size);
        at += sizeof size;
        if (size > bytes.size() - at)
            throw inputError(file, at,
                             "found a value of " + std::to_string(size) +
                                 " bytes, expected one within the file");
        at += size;
    }
}

void requireFlat(const InputFile& file, const Imf::Header& header)
{
    if (header.hasType() && header.type() != Imf::SCANLINEIMAGE && header.type() != Imf::TILEDIMAGE)
        throw inputError(file, "found a part of type " + inQuotes(header.type()) +
                                   ", expected an image of scan lines or tiles");
}

std::string textOf(const Imf::Header& header, const char* name)
{
    const auto* text = header.findTypedAttribute<Imf::StringAttribute>(name);
    return text ? text->value() : std::string();
}

/// Name without its layers: "R" of "diffuse.R".
std::string_view lastName(std::string_view name)
{
    return name.substr(name.rfind('.') + 1);
}

/// Names of the channels for red, green and blue; thrice the same where there is only one channel.
std::array<std::string, 3> channelsOf(const InputFile& file, const Imf::Header& header)
{
    std::array<std::string, 3> found;
    std::string all;
    size_t count = 0;
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i, ++count) {
        const std::string name = i.name();
        all += (all.empty() ? "" : ", ") + name;
        const size_t c = std::string_view("RGB").find(lastName(name));
        // "R" itself comes before the "R" of a layer, of which the first in the file counts.
        if (c < 3 && lastName(name).size() == 1 && (found[c].empty() || name.size() == 1))
            found[c] = name;
    }
    if (count == 1) found.fill(all);
    if (std::any_of(found.begin(), found.end(), [](const auto& name) { return name.empty(); }))
        throw inputError(file, "found " + std::to_string(count) + " channels (" + all +
                                   "), expected R, G, B or a single one");
    return found;
}

TableImage emptyImage(const InputFile& file, const Imath::Box2i& window)
{
    const int64_t width = int64_t(window.max.x) - window.min.x + 1,
                  height = int64_t(window.max.y) - window.min.y + 1;
    const bool sensible =
        width > 0 && height > 0 && width <= int64_t(kMostPixels) &&
        height <= int64_t(kMostPixels) && size_t(width) * size_t(height) <= kMostPixels &&
        size_t(width) * size_t(height) * sizeof(Vec3f) <= kMostRatio * file.size() + kAlwaysAllowed;
    if (!sensible)
        throw inputError(file,
                         "found " + std::to_string(width) + " x " + std::to_string(height) +
                             " pixels in " + std::to_string(file.size()) +
                             " bytes, expected up to 2^24 pixels and far fewer in a small file");
    TableImage image;
    image.width = size_t(width);
    image.height = size_t(height);
    image.pixels.resize(image.width * image.height);
    return image;
}

TableImage readFirstPart(const InputFile& file)
{
    MemoryStream stream(file);
    Imf::InputFile input(stream, 0);  // no threads of OpenEXR's own
    const Imf::Header& header = input.header();
    requireFlat(file, header);
    const Imath::Box2i window = header.dataWindow();
    const std::array<std::string, 3> channels = channelsOf(file, header);
    TableImage image = emptyImage(file, window);
    image.layout = textOf(header, "fbrdf:layout");
    image.angles = textOf(header, "fbrdf:theta_i");
    Imf::FrameBuffer buffer;
    const bool grey = channels[0] == channels[1];
    for (size_t c = 0; c < (grey ? 1u : 3u); ++c)
        buffer.insert(channels[c],
                      Imf::Slice::Make(Imf::FLOAT, &image.pixels[0][static_cast<int>(c)], window,
                                       sizeof(Vec3f), image.width * sizeof(Vec3f)));
    input.setFrameBuffer(buffer);
    input.readPixels(window.min.y, window.max.y);
    if (grey)
        for (Vec3f& pixel : image.pixels) pixel = Vec3f(pixel.x);
    return image;
}

}  // namespace

bool isExr(const InputFile& file)
{
    return file.bytes().substr(0, kExrMagic.size()) == kExrMagic;
}

TableImage readExrImage(const InputFile& file)
{
    requireAttributesWithin(file);
    try {
        return readFirstPart(file);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        std::string why = error.what();
        std::replace(why.begin(), why.end(), '\n', ' ');
        throw inputError(file, "found an OpenEXR file that cannot be read: " + why);
    }
}

}  // namespace fbrdf

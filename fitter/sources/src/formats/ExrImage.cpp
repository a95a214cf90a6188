// Pixels come from OpenEXR's C++ library: its decoders of lossy compressions are older and more
// tested than those of the core library, which fbrdf::io uses for ZIP alone.
#include "formats/ExrImage.h"

#include "Tristimulus.h"

#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <optional>

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
        throw inputError(file, position, Found("the end of the file").expected("a name"));
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
            throw inputError(file, at,
                             Found("the end of the file").expected("the size of a value"));
        std::memcpy(&size, bytes.data() + at, sizeof size);
        at += sizeof size;
        if (size > bytes.size() - at)
            throw inputError(file, at,
                             Found("a value of " + std::to_string(size) + " bytes")
                                 .expected("one within the file"));
        at += size;
    }
}

void requireFlat(const InputFile& file, const Imf::Header& header)
{
    if (header.hasType() && header.type() != Imf::SCANLINEIMAGE && header.type() != Imf::TILEDIMAGE)
        throw inputError(file, Found("a part of type " + inQuotes(header.type()))
                                   .expected("an image of scan lines or tiles"));
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

/// The layer of a channel's name: "diffuse." of "diffuse.R".
std::string layerOf(std::string_view name)
{
    return std::string(name.substr(0, name.size() - lastName(name).size()));
}

/// Channels that are read together, and what they are.
struct Channels {
    std::array<std::string, 3> names;
    enum class Kind { grey, rgb, xyz } kind = Kind::grey;
};

/// Channels of a layer, by the last part of their names in upper case.
using Layer = std::map<std::string, std::string>;

std::string upperCase(std::string_view text)
{
    std::string upper = lowerCase(text);
    for (char& c : upper)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return upper;
}

/// The channels of each layer; that without a name comes first, as its name is the least.
std::map<std::string, Layer> layersOf(const Imf::Header& header, std::string& all)
{
    std::map<std::string, Layer> layers;
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
        const std::string name = i.name();
        layers[layerOf(name)][upperCase(lastName(name))] = name;
        all += (all.empty() ? "" : ", ") + name;
    }
    return layers;
}

std::optional<Channels> channelsOf(const Layer& layer)
{
    const auto find = [&](std::array<const char*, 3> names, Channels::Kind kind) {
        std::optional<Channels> found(Channels{{}, kind});
        for (size_t c = 0; found && c < 3; ++c) {
            const auto channel = layer.find(names[c]);
            if (channel == layer.end())
                found.reset();
            else
                found->names[c] = channel->second;
        }
        return found;
    };
    if (auto rgb = find({"R", "G", "B"}, Channels::Kind::rgb)) return rgb;
    if (auto rgb = find({"RED", "GREEN", "BLUE"}, Channels::Kind::rgb)) return rgb;
    if (auto xyz = find({"X", "Y", "Z"}, Channels::Kind::xyz)) return xyz;
    const bool alpha = layer.count("A") != 0;
    if (layer.size() != (alpha ? 2u : 1u)) return {};
    Channels grey;
    grey.names.fill(layer.begin()->first == "A" ? layer.rbegin()->second : layer.begin()->second);
    return grey;
}

/// The channels of the first layer that has a colour, or of the only one where that is grey.
Channels channelsOf(const InputFile& file, const Imf::Header& header)
{
    std::string all;
    const std::map<std::string, Layer> layers = layersOf(header, all);
    for (const auto& [name, layer] : layers)
        if (const auto found = channelsOf(layer);
            found && (found->kind != Channels::Kind::grey || layers.size() == 1))
            return *found;
    throw inputError(
        file,
        Found("the channels " + all).expected("R, G, B or X, Y, Z of one layer, or a single one"));
}

/// True for primaries and a white that are those of Rec. 709, within rounding.
bool isRec709(const Imf::Chromaticities& c)
{
    const Imf::Chromaticities rec709;
    const auto near = [](const Imath::V2f& a, const Imath::V2f& b) {
        return (a - b).length() < 2e-3f;
    };
    return near(c.red, rec709.red) && near(c.green, rec709.green) && near(c.blue, rec709.blue) &&
           near(c.white, rec709.white);
}

/// Turns pixels into linear sRGB, and notes how.
void convertColours(const Imf::Header& header, Channels::Kind kind, TableImage& image)
{
    if (kind == Channels::Kind::grey) {
        for (Vec3f& pixel : image.pixels) pixel = Vec3f(pixel.x);
        image.assumptions.emplace_back("one channel as grey");
        return;
    }
    const bool declared = Imf::hasChromaticities(header);
    const Imf::Chromaticities primaries =
        declared ? Imf::chromaticities(header) : Imf::Chromaticities();
    if (kind == Channels::Kind::xyz) {
        if (!declared) image.assumptions.push_back(describeWhite(XyzWhite::d65));
        for (Vec3f& pixel : image.pixels)
            pixel = Vec3f(linearSrgbFromXyz(Vec3d(pixel), double(primaries.white.x),
                                            double(primaries.white.y)));
        return;
    }
    if (!declared) image.assumptions.emplace_back("primaries of R, G, B are those of Rec. 709");
    if (isRec709(primaries)) return;
    const Imath::M44f toXyz = Imf::RGBtoXYZ(primaries, 1.0f);
    for (Vec3f& pixel : image.pixels) {
        const Imath::V3f xyz = Imath::V3f(pixel.x, pixel.y, pixel.z) * toXyz;
        pixel = Vec3f(linearSrgbFromXyz({double(xyz.x), double(xyz.y), double(xyz.z)},
                                        double(primaries.white.x), double(primaries.white.y)));
    }
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
        throw inputError(file, Found(std::to_string(width) + " x " + std::to_string(height) +
                                     " pixels in " + std::to_string(file.size()) + " bytes")
                                   .expected("up to 2^24 pixels and far fewer in a small file"));
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
    const Channels channels = channelsOf(file, header);
    TableImage image = emptyImage(file, window);
    image.layout = textOf(header, "fbrdf:layout");
    image.angles = textOf(header, "fbrdf:theta_i");
    Imf::FrameBuffer buffer;
    const bool grey = channels.kind == Channels::Kind::grey;
    for (size_t c = 0; c < (grey ? 1u : 3u); ++c)
        buffer.insert(channels.names[c],
                      Imf::Slice::Make(Imf::FLOAT, &image.pixels[0][static_cast<int>(c)], window,
                                       sizeof(Vec3f), image.width * sizeof(Vec3f)));
    input.setFrameBuffer(buffer);
    input.readPixels(window.min.y, window.max.y);
    convertColours(header, channels.kind, image);
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

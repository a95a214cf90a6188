// See FormatPage.h: no header of fbrdf but that one.
#include "io/FormatPage.h"

#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatVectorAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>

#include <vector>

namespace page {
namespace {

struct Part {
    Imf::Header header;
    std::vector<float> pixels;  ///< channel contiguous
};

Part makePart(const std::string& name, int width, int height, const char* channels,
              const std::string& storage, std::vector<float> pixels)
{
    Part part{Imf::Header(width, height), std::move(pixels)};
    part.header.displayWindow() = Imath::Box2i({0, 0}, {8, 8});  // one for all parts
    part.header.setName(name);
    part.header.setType(Imf::SCANLINEIMAGE);
    part.header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* channel = channels; *channel; ++channel)
        part.header.channels().insert(std::string(1, *channel),
                                      Imf::Channel(storage == "float" ? Imf::FLOAT : Imf::HALF));
    part.header.insert("fbrdf:storage", Imf::StringAttribute(storage));
    part.header.insert("fbrdf:lower", Imf::V3fAttribute({0, 0, 0}));
    part.header.insert("fbrdf:upper", Imf::V3fAttribute({1, 1, 1}));
    return part;
}

void describeMaterial(Imf::Header& header, const std::string& form, std::vector<float> scales)
{
    header.insert("fbrdf:version", Imf::IntAttribute(1));
    header.insert("fbrdf:units", Imf::StringAttribute("1/sr"));
    header.insert("fbrdf:colorspace", Imf::StringAttribute("lin_rec709"));
    header.insert("fbrdf:form", Imf::StringAttribute(form));
    header.insert("fbrdf:scales", Imf::FloatVectorAttribute(scales));
    header.insert("fbrdf:name", Imf::StringAttribute("by the page"));
    header.insert("fbrdf:note:source", Imf::StringAttribute("docs/format.md"));
    header.insert("fbrdf:of a later version", Imf::StringAttribute("ignored"));
}

/// Gives the pixels to OpenEXR: as half where the part is stored so.
template <class Output>
void writePixels(Output& output, const Part& part)
{
    std::vector<half> halves(part.pixels.begin(), part.pixels.end());
    const Imath::Box2i window = part.header.dataWindow();
    const auto width = static_cast<size_t>(window.max.x + 1);
    const size_t channels = part.pixels.size() / (width * static_cast<size_t>(window.max.y + 1));
    Imf::FrameBuffer buffer;
    for (size_t c = 0; c < channels; ++c) {
        const std::string name(1, channels == 1 ? 'Y' : "RGB"[c]);
        const bool isHalf = part.header.channels()[name].type == Imf::HALF;
        const size_t bytes = isHalf ? sizeof(half) : sizeof(float);
        const void* first = isHalf ? static_cast<const void*>(&halves[c])
                                   : static_cast<const void*>(&part.pixels[c]);
        buffer.insert(name, Imf::Slice::Make(isHalf ? Imf::HALF : Imf::FLOAT, first, window,
                                             bytes * channels, bytes * channels * width));
    }
    output.setFrameBuffer(buffer);
    output.writePixels(window.max.y + 1);
}

constexpr char kThreeTables[] = R"({"name": "three", "tables": [
    {"name": "a", "domain": {"grid": {"symmetric": false,
        "axes": [{"size": 2, "from": "cos", "exponent": 1}]}}},
    {"name": "b", "domain": {"disc": {"size": 3, "gamma": 1, "radius": 1}}},
    {"name": "c", "uniform": true, "domain": {"grid": {"symmetric": false,
        "axes": [{"size": 3, "from": "1-cos", "exponent": 0.5}]}}}],
    "terms": [[{"table": 0, "argument": ["theta_i"]}, {"table": 1, "argument": "h"}],
              [{"table": 2, "argument": ["theta_h"]}]]})";

constexpr char kGrey[] = R"({"name":"q","tables":[{"name":"q","uniform":false,"domain":
    {"grid":{"symmetric":false,"axes":[{"size":2,"from":"1-cos","exponent":1.0}]}}}],
    "terms":[[{"table":0,"argument":["theta_h"]}]]})";

}  // namespace

void writeThreeTables(const std::string& path)
{
    std::vector<Part> parts;
    parts.push_back(makePart("a", 2, 1, "RGB", "float", {0, 0, 0, 2, 2, 2}));
    parts.push_back(makePart("b", 3, 3, "Y", "half", {-3, -1, -3, -1, 1, -1, -3, -1, -3}));
    // With lower = 0 and upper = 65535, log2 F is v itself: 3 - 2 + 1 = 2, 2 - 2 + 4 = 4 and
    // 4 - 2 + 1 = 3.
    parts.push_back(makePart("c", 3, 1, "RGB", "log8", {1, 1, 1, 4, 4, 4, 1, 1, 1}));
    describeMaterial(parts[0].header, kThreeTables, {1, 2, 3, 0, 0, 1});
    Imf::Header& log8 = parts[2].header;
    log8.insert("fbrdf:upper", Imf::V3fAttribute({65535, 65535, 65535}));
    log8.insert("fbrdf:stride", Imf::V3iAttribute({1, 1, 1}));
    log8.insert("fbrdf:offset", Imf::V3iAttribute({-2, -2, -2}));
    log8.insert("fbrdf:start", Imf::V3iAttribute({3, 3, 3}));
    log8.insert("fbrdf:unsupported", Imf::StringAttribute("2 1"));
    const std::vector<Imf::Header> headers = {parts[0].header, parts[1].header, parts[2].header};
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), 3, false, 0);
    for (int k = 0; k < 3; ++k) {
        Imf::OutputPart output(file, k);
        writePixels(output, parts[static_cast<size_t>(k)]);
    }
}

void writeGrey(const std::string& path)
{
    Part part = makePart("q", 2, 1, "Y", "half", {0, 0});
    describeMaterial(part.header, kGrey, {0.15915494f, 0.15915494f, 0.15915494f});
    Imf::OutputFile file(path.c_str(), part.header, 0);
    writePixels(file, part);
}

}  // namespace page

#include "ExrHeader.h"

#include "Printable.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace fbrdf {
namespace {

constexpr char kMagic[] = {'\x76', '\x2f', '\x31', '\x01'};
constexpr uint32_t kExrVersion = 2, kLongNames = 0x400, kMultiPart = 0x1000;
// OpenEXR allows names of 255 bytes. The other limits are far above any material; they bound the
// work for a file that lists empty attributes or parts without end.
constexpr size_t kMaxName = 255, kMaxAttributes = 4096, kMaxParts = 64;
constexpr int kMaxLines = 1 << 24;  // Form.cpp: no table has more texels
// Deflate shrinks by at most 1032:1 (zlib's "Technical Details"), run lengths by less.
constexpr size_t kMaxZipRatio = 1032;

enum Compression { none = 0, runLength = 1, zipOneLine = 2, zip = 3 };

/// Reads little-endian values at a position that never passes the end of the file.
class Cursor {
public:
    Cursor(const std::string& bytes, const std::string& where) : bytes_(bytes), where_(where) {}

    [[noreturn]] void fail(size_t at, const std::string& what) const
    {
        throw Error(ErrorKind::input, where_ + ": byte " + std::to_string(at), what);
    }
    [[noreturn]] void fail(const std::string& what) const { fail(position, what); }

    void need(uint64_t count) const
    {
        if (position > bytes_.size() || count > bytes_.size() - position)
            fail(Found("the end of the file").expected(std::to_string(count) + " more bytes"));
    }
    uint64_t integer(size_t width)
    {
        need(width);
        uint64_t value = 0;
        for (size_t i = 0; i < width; ++i)
            value |= uint64_t(static_cast<unsigned char>(bytes_[position + i])) << (8 * i);
        position += width;
        return value;
    }
    uint32_t u32() { return static_cast<uint32_t>(integer(4)); }
    int32_t i32() { return static_cast<int32_t>(u32()); }
    int u8() { return static_cast<int>(integer(1)); }

    /// Reads a name up to its zero byte. An empty name is the end of a list.
    std::string name()
    {
        const size_t end = bytes_.find('\0', position);
        if (end == std::string::npos || end - position > kMaxName)
            fail(Found("no end of a name").expected("one within 255 bytes"));
        const std::string text = bytes_.substr(position, end - position);
        position = end + 1;
        return text;
    }

    std::string text(const ExrAttribute& attribute) const
    {
        return bytes_.substr(attribute.offset, attribute.size);
    }

    size_t position = 0;

private:
    const std::string& bytes_;
    const std::string& where_;
};

const ExrAttribute& required(const ExrPart& part, const char* name, const char* type, size_t size,
                             const Cursor& cursor)
{
    const ExrAttribute* attribute = part.find(name);
    if (!attribute)
        cursor.fail(Found("no '" + std::string(name) + "'").expected("it in the header"));
    if (attribute->type != type || (size && attribute->size != size))
        cursor.fail(attribute->offset,
                    Found("'" + std::string(name) + "' of type " + attribute->type + " and " +
                          std::to_string(attribute->size) + " bytes")
                        .expected(std::string("type ") + type));
    return *attribute;
}

struct Window {
    int64_t x0, y0, x1, y1;
};

Window readWindow(const ExrPart& part, const char* name, Cursor cursor)
{
    cursor.position = required(part, name, "box2i", 16, cursor).offset;
    const int64_t x0 = cursor.i32(), y0 = cursor.i32(), x1 = cursor.i32(), y1 = cursor.i32();
    // The library adds coordinates as int, which those near its limits would overflow.
    const int64_t limit = int64_t(1) << 30;
    for (const int64_t v : {x0, y0, x1, y1})
        if (v < -limit || v > limit)
            cursor.fail(Found("a window beyond 2^30").expected("coordinates within it"));
    return {x0, y0, x1, y1};
}

void readDataWindow(ExrPart& part, const Cursor& cursor)
{
    const Window w = readWindow(part, "dataWindow", cursor);
    readWindow(part, "displayWindow", cursor);  // no texel depends on it, but the library reads it
    const int64_t width = w.x1 - w.x0 + 1, height = w.y1 - w.y0 + 1;
    if (width < 1 || height < 1 || width > kMaxLines || height > kMaxLines ||
        width * height > kMaxLines)
        cursor.fail(part.find("dataWindow")->offset,
                    Found(std::to_string(width) + " x " + std::to_string(height) + " texels")
                        .expected("1 to 2^24"));
    part.width = static_cast<int>(width);
    part.height = static_cast<int>(height);
    part.firstLine = static_cast<int>(w.y0);
}

void readChannels(ExrPart& part, Cursor cursor)
{
    const ExrAttribute& list = required(part, "channels", "chlist", 0, cursor);
    cursor.position = list.offset;
    std::string names;
    uint32_t type = 0;
    while (true) {
        const std::string name = cursor.name();
        if (name.empty()) break;
        const uint32_t channelType = cursor.u32();
        if (channelType != 1 && channelType != 2)
            cursor.fail(Found("pixel type " + std::to_string(channelType))
                            .expected("1 (half) or 2 (float)"));
        if (!names.empty() && channelType != type)
            cursor.fail(Found("channels of half and float").expected("one type"));
        type = channelType;
        cursor.u32();  // pLinear and its padding mean nothing here
        const int32_t xSampling = cursor.i32(), ySampling = cursor.i32();
        if (xSampling != 1 || ySampling != 1)
            cursor.fail(Found("a subsampled channel").expected("none"));
        names += name + " ";
    }
    // Channels are sorted by name.
    if (names != "Y " && names != "B G R ")
        cursor.fail(list.offset,
                    Found("channels '" + printable(names) + "'").expected("Y, or R, G, B"));
    if (cursor.position != list.offset + list.size)
        cursor.fail(Found("a channel list that does not end where its size says")
                        .expected("one that does"));
    part.channels = names == "Y " ? 1 : 3;
    part.half = type == 1;
}

void readEncoding(ExrPart& part, bool multiPart, Cursor cursor)
{
    cursor.position = required(part, "compression", "compression", 1, cursor).offset;
    part.compression = cursor.u8();
    if (part.compression > zip)
        cursor.fail(Found("compression " + std::to_string(part.compression))
                        .expected("0 to 3 (none, rle, zips, zip)"));
    cursor.position = required(part, "lineOrder", "lineOrder", 1, cursor).offset;
    if (cursor.u8() > 1) cursor.fail(Found("an unknown line order").expected("0 or 1"));
    if (!multiPart) return;
    const std::string type = cursor.text(required(part, "type", "string", 0, cursor));
    if (type != "scanlineimage")
        cursor.fail(Found("a part of type '" + printable(type) + "'").expected("'scanlineimage'"));
}

ExrPart readHeader(Cursor& cursor, bool multiPart)
{
    ExrPart part;
    while (true) {
        ExrAttribute attribute;
        attribute.name = cursor.name();
        if (attribute.name.empty()) break;
        attribute.type = cursor.name();
        attribute.size = cursor.u32();
        cursor.need(attribute.size);
        attribute.offset = cursor.position;
        cursor.position += attribute.size;
        // Readers differ in which of two they take, so none is taken.
        if (part.find(attribute.name))
            cursor.fail(attribute.offset,
                        Found("'" + printable(attribute.name) + "' twice").expected("it once"));
        part.attributes.push_back(attribute);
        if (part.attributes.size() > kMaxAttributes)
            cursor.fail(Found("more than 4096 attributes").expected("at most 4096"));
    }
    readDataWindow(part, cursor);
    readChannels(part, cursor);
    readEncoding(part, multiPart, cursor);
    return part;
}

void checkChunk(const ExrPart& part, size_t partIndex, int chunk, bool multiPart, Cursor cursor)
{
    const size_t start = cursor.position;
    if (multiPart && cursor.u32() != partIndex)
        cursor.fail(start,
                    Found("a chunk of another part").expected("part " + std::to_string(partIndex)));
    const int line = chunk * linesPerChunk(part);
    if (cursor.i32() != part.firstLine + line)
        cursor.fail(start,
                    Found("a chunk of other lines").expected("line " + std::to_string(line)));
    const size_t size = cursor.u32();
    cursor.need(size);
    const auto lines = static_cast<size_t>(std::min(linesPerChunk(part), part.height - line));
    const size_t whole = static_cast<size_t>(part.width) * lines *
                         static_cast<size_t>(part.channels) * (part.half ? 2u : 4u);
    // A chunk that compression does not shrink is stored as it is, so none is longer than its
    // texels.
    const bool fits =
        part.compression == none ? size == whole : size <= whole && size >= whole / kMaxZipRatio;
    if (size == 0 || !fits)
        cursor.fail(start,
                    Found("a chunk of " + std::to_string(size) + " bytes for " +
                          std::to_string(whole) + " bytes of texels")
                        .expected(part.compression == none ? "as many"
                                                           : "at most as many, at least 1/1032"));
}

void checkChunks(const std::vector<ExrPart>& parts, bool multiPart, Cursor cursor)
{
    for (size_t p = 0; p < parts.size(); ++p) {
        const ExrPart& part = parts[p];
        const int chunks = (part.height + linesPerChunk(part) - 1) / linesPerChunk(part);
        if (const ExrAttribute* count = part.find("chunkCount")) {
            Cursor at = cursor;
            at.position = count->offset;
            if (count->type != "int" || count->size != 4 || at.i32() != chunks)
                cursor.fail(count->offset,
                            Found("a wrong chunkCount").expected(std::to_string(chunks)));
        }
        // The offsets of all parts follow each other behind the headers, eight bytes a chunk. They
        // may point anywhere, also at one chunk twice, which its line then gives away.
        cursor.need(uint64_t(chunks) * 8);
        for (int c = 0; c < chunks; ++c) {
            Cursor at = cursor;
            const uint64_t offset = cursor.integer(8);
            at.position = static_cast<size_t>(offset);
            at.need(8);
            checkChunk(part, p, c, multiPart, at);
        }
    }
}

}  // namespace

const ExrAttribute* ExrPart::find(const std::string& name) const
{
    const auto found = std::find_if(attributes.begin(), attributes.end(),
                                    [&](const ExrAttribute& a) { return a.name == name; });
    return found == attributes.end() ? nullptr : &*found;
}

int linesPerChunk(const ExrPart& part)
{
    return part.compression == zip ? 16 : 1;
}

bool looksLikeExr(const std::string& bytes)
{
    return bytes.size() >= sizeof kMagic && std::memcmp(bytes.data(), kMagic, sizeof kMagic) == 0;
}

std::vector<ExrPart> scanExr(const std::string& bytes, const std::string& where)
{
    Cursor cursor(bytes, where);
    if (!looksLikeExr(bytes)) cursor.fail(Found("other first bytes").expected("an OpenEXR file"));
    cursor.position = sizeof kMagic;
    const uint32_t version = cursor.u32();
    const bool multiPart = version & kMultiPart;
    // Any other flag stands for tiles or deep data, of which a material has none.
    if ((version & ~(kLongNames | kMultiPart)) != kExrVersion)
        cursor.fail(sizeof kMagic, Found("OpenEXR version and flags " + std::to_string(version))
                                       .expected("version 2 with scan lines"));
    std::vector<ExrPart> parts;
    do {
        parts.push_back(readHeader(cursor, multiPart));
        if (parts.size() > kMaxParts)
            cursor.fail(Found("more than 64 parts").expected("at most 64"));
        cursor.need(1);
    } while (multiPart && bytes[cursor.position] != '\0');
    if (multiPart) ++cursor.position;  // an empty header ends the list
    checkChunks(parts, multiPart, cursor);
    return parts;
}

}  // namespace fbrdf

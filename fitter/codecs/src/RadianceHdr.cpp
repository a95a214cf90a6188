#include "LightPicture.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace fbrdf {
namespace {

using Rgbe = std::array<uint8_t, 4>;

/// Widths between which scan lines may have new run lengths.
constexpr int kLeastNew = 8, kMostNew = 0x7fff;
constexpr size_t kLongestLine = 4096, kMostLines = 4096;

/// Sides and orientation of a picture.
struct HdrSides {
    int width = 0, height = 0;
    bool isUpwards = false, isLeftwards = false;
};

class HdrReader {
public:
    HdrReader(const std::string& bytes, const std::string& where) : bytes_(bytes), where_(where) {}

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const
    {
        throw Error(ErrorKind::input, where_ + ": byte " + std::to_string(at_),
                    Found(found).expected(expected));
    }

    std::string line()
    {
        const size_t end = bytes_.find('\n', at_);
        if (end == std::string::npos || end - at_ > kLongestLine)
            fail("a header that does not end", "a Radiance picture");
        std::string text = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        if (!text.empty() && text.back() == '\r') text.pop_back();
        return text;
    }

    uint8_t byte()
    {
        if (at_ >= bytes_.size()) fail("the end of the file", "more pixels");
        return static_cast<uint8_t>(bytes_[at_++]);
    }

    /// True, and past it, where a scan line of new run lengths begins.
    bool beginsNew(int width)
    {
        if (width < kLeastNew || width > kMostNew || at_ + 4 > bytes_.size()) return false;
        const auto* head = reinterpret_cast<const uint8_t*>(bytes_.data()) + at_;
        if (head[0] != 2 || head[1] != 2 || ((head[2] << 8) | head[3]) != width) return false;
        at_ += 4;
        return true;
    }

private:
    const std::string& bytes_;
    const std::string& where_;
    size_t at_ = 0;
};

/// One line of the header. exposure: the product of all.
void readVariable(const HdrReader& reader, const std::string& line, double& exposure)
{
    if (line.rfind("FORMAT=", 0) == 0 && line != "FORMAT=32-bit_rle_rgbe")
        reader.fail(line.substr(0, 40), "FORMAT=32-bit_rle_rgbe (Radiance: ra_xyze -r)");
    if (line.rfind("EXPOSURE=", 0) != 0) return;
    // Numbers of the file, not of the host's locale; spaces before and anything behind are allowed.
    const char *first = line.c_str() + 9, *const last = line.c_str() + line.size();
    while (first != last && (*first == ' ' || *first == '+')) ++first;
    double factor = 0.0;
    const auto parsed = std::from_chars(first, last, factor);
    if (parsed.ec != std::errc() || !(factor > 0.0) || !std::isfinite(factor))
        reader.fail(line.substr(0, 40), "an exposure above 0");
    exposure *= factor;
}

double readHeader(HdrReader& reader)
{
    const std::string first = reader.line();
    if (first.rfind("#?", 0) != 0) reader.fail("no #?", "a Radiance picture");
    double exposure = 1.0;
    for (size_t i = 0; i < kMostLines; ++i) {
        const std::string line = reader.line();
        if (line.empty()) {
            if (!(exposure > 0.0) || !std::isfinite(1.0 / exposure))
                reader.fail("exposures whose product is no number", "one above 0");
            return exposure;
        }
        readVariable(reader, line, exposure);
    }
    reader.fail("a header of more than 4096 lines", "a Radiance picture");
}

HdrSides readSides(HdrReader& reader)
{
    const std::string line = reader.line();
    HdrSides sides;
    char vertical = 0, horizontal = 0, end = 0;
    if (std::sscanf(line.c_str(), "%cY %7d %cX %7d%c", &vertical, &sides.height, &horizontal,
                    &sides.width, &end) != 4 ||
        (vertical != '-' && vertical != '+') || (horizontal != '-' && horizontal != '+'))
        reader.fail("\"" + line.substr(0, 40) + "\"",
                    "rows, as in \"-Y 1024 +X 2048\" (Radiance: protate turns columns into rows)");
    sides.isUpwards = vertical == '+';
    sides.isLeftwards = horizontal == '-';
    return sides;
}

/// Four runs of bytes, one a channel.
void readNewLine(HdrReader& reader, std::vector<Rgbe>& row)
{
    for (size_t channel = 0; channel < 4; ++channel)
        for (size_t x = 0; x < row.size();) {
            const int code = reader.byte();
            const auto count = static_cast<size_t>(code > 128 ? code - 128 : code);
            if (count == 0 || x + count > row.size())
                reader.fail("a run of " + std::to_string(count) + " bytes", "one within its row");
            const uint8_t value = code > 128 ? reader.byte() : uint8_t(0);
            for (size_t i = 0; i < count; ++i)
                row[x++][channel] = code > 128 ? value : reader.byte();
        }
}

/// Pixels, or (1, 1, 1, count) for repetitions of the one before; several in a row are digits of
/// base 256.
void readOldLine(HdrReader& reader, std::vector<Rgbe>& row, Rgbe& before)
{
    int shift = 0;
    for (size_t x = 0; x < row.size();) {
        Rgbe pixel{};
        for (uint8_t& value : pixel) value = reader.byte();
        if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
            row[x++] = before = pixel;
            shift = 0;
            continue;
        }
        const size_t count = size_t(pixel[3]) << shift;
        if (shift > 16 || x + count > row.size())
            reader.fail("a run of " + std::to_string(count) + " pixels", "one within its row");
        for (size_t i = 0; i < count; ++i) row[x++] = before;
        shift += 8;
    }
}

/// Mantissas count as they are, as other readers do, without the half step of Radiance's own.
Vec3f radianceOf(const Rgbe& pixel, double exposure)
{
    if (pixel[3] == 0) return Vec3f(0.0f);
    const double scale = std::ldexp(1.0, int(pixel[3]) - 136) / exposure;
    return Vec3f(Vec3d(pixel[0], pixel[1], pixel[2]) * scale);
}

void turn(LightPicture& picture, const HdrSides& sides)
{
    const auto width = static_cast<std::ptrdiff_t>(picture.width);
    auto& texels = picture.texels;
    // Upwards and leftwards is the whole list backwards.
    if (sides.isUpwards) std::reverse(texels.begin(), texels.end());
    if (sides.isUpwards != sides.isLeftwards)
        for (auto row = texels.begin(); row != texels.end(); row += width)
            std::reverse(row, row + width);
}

}  // namespace

LightPicture decodeRadianceHdr(const std::string& bytes, const std::string& where)
{
    HdrReader reader(bytes, where);
    const double exposure = readHeader(reader);
    const HdrSides sides = readSides(reader);
    LightRows rows(sides.width, sides.height, where);
    // A row takes at least 4 bytes, and one of width w at least w / 32 in new run lengths.
    std::vector<Rgbe> row(static_cast<size_t>(sides.width));
    std::vector<Vec3f> light(row.size());
    Rgbe before{};
    for (int y = 0; y < sides.height; ++y) {
        if (reader.beginsNew(sides.width))
            readNewLine(reader, row);
        else
            readOldLine(reader, row, before);
        for (size_t x = 0; x < row.size(); ++x) light[x] = radianceOf(row[x], exposure);
        rows.add(light);
    }
    LightPicture picture = rows.picture();
    turn(picture, sides);
    if (exposure != 1.0) picture.notes += "; an exposure was divided out";
    if (sides.isUpwards || sides.isLeftwards) picture.notes += "; turned as its header says";
    return picture;
}

}  // namespace fbrdf

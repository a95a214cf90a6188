#include "ExrHeader.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <algorithm>
#include <cstdint>

namespace fbrdf {
namespace {

/// Far above any panorama.
constexpr int64_t kLongestExrSide = 1 << 17, kPixelsOfByte = 2048, kPixelsOfAnyFile = 1 << 20;
/// A row of 16 384 pixels and 256 high; published tiles have sides of 16 to 512.
constexpr int64_t kMostTilePixels = 1 << 22;

/// "OpenEXR File Layout", little-endian: a magic number, a version, and for each part attributes of
/// a name, a type, a size and so many bytes, ended by an empty name.
class ExrAttributes {
public:
    ExrAttributes(const std::string& bytes, const std::string& where) : bytes_(bytes), where_(where)
    {
    }

    /// Goes to the next attribute; false at the end of a header and of the file.
    bool next()
    {
        name_ = text();
        if (name_.empty()) return false;
        text();  // the type, which follows from the names asked for
        size_ = static_cast<uint32_t>(integer(at_));
        at_ += 4;
        value_ = at_;
        if (size_ > bytes_.size() - std::min(bytes_.size(), at_))
            throw Error(ErrorKind::input, where_,
                        Found("an attribute of " + std::to_string(size_) + " bytes at byte " +
                              std::to_string(at_))
                            .expected("one that ends within the file"));
        at_ += size_;
        return true;
    }

    const std::string& name() const { return name_; }
    bool has(uint32_t size) const { return size_ >= size; }
    /// A 32-bit number of the value; 0 beyond the file.
    int64_t number(size_t index) const { return integer(value_ + 4 * index); }

private:
    int32_t integer(size_t at) const
    {
        if (at + 4 > bytes_.size()) return 0;
        uint32_t value = 0;
        for (size_t i = 0; i < 4; ++i)
            value |= uint32_t(static_cast<uint8_t>(bytes_[at + i])) << (8 * i);
        return static_cast<int32_t>(value);
    }

    std::string text()
    {
        const size_t end = at_ < bytes_.size() ? bytes_.find('\0', at_) : std::string::npos;
        if (end == std::string::npos) return {};
        std::string result = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        return result;
    }

    const std::string& bytes_;
    const std::string& where_;
    std::string name_;
    uint32_t size_ = 0;
    size_t at_ = 8, value_ = 0;
};

void requireWindow(const ExrAttributes& attributes, size_t bytes, const std::string& where)
{
    const int64_t width = attributes.number(2) - attributes.number(0) + 1,
                  height = attributes.number(3) - attributes.number(1) + 1;
    if (width < 1 || height < 1 || width > kLongestExrSide || height > kLongestExrSide ||
        !mayHavePixels(width * height, bytes))
        throw Error(ErrorKind::input, where,
                    Found("a " + attributes.name() + " of " + std::to_string(width) + " x " +
                          std::to_string(height) + " pixels in " + std::to_string(bytes) + " bytes")
                        .expected("1 to 131072 on each side, and not far more than bytes"));
}

void requireTile(const ExrAttributes& attributes, const std::string& where)
{
    const int64_t width = attributes.number(0), height = attributes.number(1);
    if (width < 1 || height < 1 || width > kLongestExrSide || height > kLongestExrSide ||
        width * height > kMostTilePixels)
        throw Error(
            ErrorKind::input, where,
            Found("tiles of " + std::to_string(width) + " x " + std::to_string(height) + " pixels")
                .expected("at most 2^22 of them (oiiotool IN --scanline -o OUT)"));
}

}  // namespace

bool mayHavePixels(int64_t pixels, size_t bytes)
{
    return pixels <= kPixelsOfByte * static_cast<int64_t>(bytes) + kPixelsOfAnyFile;
}

void requireSensibleExr(const std::string& bytes, const std::string& where)
{
    ExrAttributes attributes(bytes, where);
    const bool hasParts = bytes.size() > 5 && (static_cast<uint8_t>(bytes[5]) & 0x10) != 0;
    while (attributes.next()) {
        do {
            if (attributes.name() == "dataWindow" || attributes.name() == "displayWindow")
                requireWindow(attributes, bytes.size(), where);
            else if (attributes.name() == "tiles" && attributes.has(8))
                requireTile(attributes, where);
        } while (attributes.next());
        // After the one header of a file without parts there are pixels.
        if (!hasParts) return;
    }
}

}  // namespace fbrdf

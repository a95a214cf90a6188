#include <fbrdf/base/Text.h>
#include <fbrdf/sources/TextDecoder.h>

#include <algorithm>

namespace fbrdf {
namespace {

constexpr std::string_view kLittle = "\xFF\xFE", kBig = "\xFE\xFF";
constexpr size_t kLongestMark = 3;
constexpr unsigned kReplacement = 0xFFFD;

bool isFirstSurrogate(unsigned unit)
{
    return unit >= 0xD800 && unit < 0xDC00;
}

bool isSecondSurrogate(unsigned unit)
{
    return unit >= 0xDC00 && unit < 0xE000;
}

unsigned byteAt(std::string_view bytes, size_t i)
{
    return static_cast<unsigned char>(bytes[i]);
}

/// UTF-8 of a character, up to four bytes.
void appendUtf8(unsigned character, std::string& text)
{
    const auto add = [&](unsigned byte) { text += static_cast<char>(byte); };
    const auto addRest = [&](int shift) { add(0x80 | (character >> shift & 0x3F)); };
    if (character < 0x80) return add(character);
    if (character < 0x800) {
        add(0xC0 | character >> 6);
        return addRest(0);
    }
    if (character < 0x10000) {
        add(0xE0 | character >> 12);
    } else {
        add(0xF0 | character >> 18);
        addRest(12);
    }
    addRest(6);
    addRest(0);
}

}  // namespace

bool startsAsUtf16(std::string_view bytes)
{
    const std::string_view mark = bytes.substr(0, 2);
    return mark == kLittle || mark == kBig;
}

void TextDecoder::append(std::string_view bytes, std::string& text)
{
    if (encoding_ == Encoding::unknown) {
        pending_ += bytes;
        if (pending_.size() < kLongestMark) return;
        decide();
        const std::string first = std::move(pending_);
        pending_.clear();
        return decode(first, text);
    }
    decode(bytes, text);
}

/// Takes the mark off the bytes so far, which must suffice.
void TextDecoder::decide()
{
    if (startsAsUtf16(pending_)) {
        encoding_ =
            pending_.front() == kLittle.front() ? Encoding::utf16Little : Encoding::utf16Big;
        pending_.erase(0, 2);
    } else {
        encoding_ = Encoding::utf8;
        pending_.erase(0, pending_.size() - withoutByteOrderMark(pending_).size());
    }
}

void TextDecoder::decode(std::string_view bytes, std::string& text)
{
    if (encoding_ == Encoding::utf8) return addLines(bytes, text);
    std::string joined;
    if (!pending_.empty()) {
        joined = std::move(pending_) + std::string(bytes);
        pending_.clear();
        bytes = joined;
    }
    const bool little = encoding_ == Encoding::utf16Little;
    for (; bytes.size() >= 2; bytes.remove_prefix(2))
        addUnit(byteAt(bytes, little ? 1 : 0) << 8 | byteAt(bytes, little ? 0 : 1), text);
    pending_ = bytes;
}

void TextDecoder::addUnit(unsigned unit, std::string& text)
{
    if (surrogate_ != 0 && isSecondSurrogate(unit)) {
        addCharacter(0x10000 + ((surrogate_ - 0xD800) << 10 | (unit - 0xDC00)), text);
        surrogate_ = 0;
        return;
    }
    if (surrogate_ != 0) addCharacter(kReplacement, text);
    surrogate_ = isFirstSurrogate(unit) ? unit : 0;
    if (surrogate_ == 0) addCharacter(isSecondSurrogate(unit) ? kReplacement : unit, text);
}

void TextDecoder::addCharacter(unsigned character, std::string& text)
{
    std::string utf8;
    appendUtf8(character, utf8);
    addLines(utf8, text);
}

/// "\r\n" and "\r" become "\n".
void TextDecoder::addLines(std::string_view bytes, std::string& text)
{
    while (!bytes.empty()) {
        if (afterReturn_ && bytes.front() == '\n') bytes.remove_prefix(1);
        const size_t end = std::min(bytes.find('\r'), bytes.size());
        text += bytes.substr(0, end);
        afterReturn_ = end < bytes.size();
        if (afterReturn_) text += '\n';
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
    }
}

void TextDecoder::finish(std::string& text)
{
    if (encoding_ == Encoding::unknown) {
        decide();
        const std::string first = std::move(pending_);
        pending_.clear();
        decode(first, text);
    }
    if (surrogate_ != 0 || !pending_.empty()) addCharacter(kReplacement, text);
    surrogate_ = 0;
    pending_.clear();
}

}  // namespace fbrdf

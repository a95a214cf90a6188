#include "Html.h"

#include <fmt/format.h>

#include <cmath>

namespace fbrdf {
namespace {

const char* const kReplacement = "\xEF\xBF\xBD";  // U+FFFD

// Bytes of the character that starts at `at`, 0 when it is not valid UTF-8 (Unicode 15, Table 3-7).
size_t characterLength(const std::string& text, size_t at)
{
    const auto byte = [&](size_t i) {
        return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u;
    };
    const auto continues = [&](size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
    const unsigned first = byte(0), second = byte(1);
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first <= 0xDF) return continues(1) ? 2 : 0;
    if ((first & 0xF0u) == 0xE0u) {
        const bool overlong = first == 0xE0 && second < 0xA0;
        const bool surrogate = first == 0xED && second >= 0xA0;
        return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (first >= 0xF0 && first <= 0xF4) {
        const bool outside = (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
        return continues(1) && continues(2) && continues(3) && !outside ? 4 : 0;
    }
    return 0;
}

// XML 1.0, production 2: no control characters but tab and line ends, no U+FFFE and U+FFFF.
bool isAllowed(const std::string& character)
{
    const auto first = static_cast<unsigned char>(character[0]);
    if (first < 0x20) return first == '\t' || first == '\n' || first == '\r';
    return first != 0x7F && character != "\xEF\xBF\xBE" && character != "\xEF\xBF\xBF";
}

std::string escapedCharacter(const std::string& character)
{
    if (!isAllowed(character)) return kReplacement;
    switch (character[0]) {
        case '&': return "&amp;";
        case '<': return "&lt;";
        case '>': return "&gt;";
        case '"': return "&quot;";
        case '\'': return "&#39;";
        default: return character;
    }
}

}  // namespace

std::string escaped(const std::string& text)
{
    std::string result;
    for (size_t at = 0; at < text.size();) {
        const size_t length = characterLength(text, at);
        result += length == 0 ? kReplacement : escapedCharacter(text.substr(at, length));
        at += length == 0 ? 1 : length;
    }
    return result;
}

std::string number(double value)
{
    if (std::isnan(value)) return "\xE2\x80\x93";
    if (std::isinf(value)) return value > 0 ? "\xE2\x88\x9E" : "\xE2\x88\x92\xE2\x88\x9E";
    const double size = std::abs(value);
    if (size >= 1000.0 && size < 1e15)
        return (value < 0 ? "-" : "") + grouped(static_cast<uint64_t>(std::llround(size)));
    if (size != 0.0 && (size < 1e-3 || size >= 1e15)) return fmt::format("{:.1e}", value);
    const int decimals =
        size == 0.0 ? 0 : std::max(0, 2 - static_cast<int>(std::floor(std::log10(size))));
    return fmt::format("{:.{}f}", value, decimals);
}

std::string shortNumber(double value)
{
    return std::isfinite(value) ? fmt::format("{:.3g}", value) : number(value);
}

std::string grouped(uint64_t value)
{
    std::string digits = std::to_string(value);
    for (size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
    return digits;
}

std::string base64(const std::vector<uint8_t>& bytes)
{
    static const char kDigits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string result;
    for (size_t at = 0; at < bytes.size(); at += 3) {
        const size_t count = std::min<size_t>(3, bytes.size() - at);
        uint32_t group = 0;
        for (size_t i = 0; i < 3; ++i) group = group << 8 | (i < count ? bytes[at + i] : 0u);
        for (size_t i = 0; i < 4; ++i)
            result += i <= count ? kDigits[group >> (18 - 6 * i) & 63u] : '=';
    }
    return result;
}

std::string element(const std::string& name, const std::string& attributes,
                    const std::string& content)
{
    return "<" + name + (attributes.empty() ? "" : " ") + attributes + ">" + content + "</" + name +
           ">";
}

}  // namespace fbrdf

#include <fbrdf/base/Percent.h>

#include <charconv>

namespace fbrdf {
namespace {

bool isPlain(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '_' || c == '-' || c == '~';
}

}  // namespace

std::string percentEncoded(std::string_view text)
{
    constexpr const char* kDigits = "0123456789ABCDEF";
    std::string encoded;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (isPlain(c))
            encoded += c;
        else
            encoded += {'%', kDigits[byte / 16], kDigits[byte % 16]};
    }
    return encoded;
}

std::string percentDecoded(std::string_view text)
{
    std::string plain;
    for (size_t i = 0; i < text.size(); ++i) {
        const std::string_view digits = text.substr(i + 1, 2);
        unsigned int byte = 0;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
        const bool isCode = text[i] == '%' && digits.size() == 2 && end == digits.data() + 2 &&
                            error == std::errc();
        plain += isCode ? static_cast<char>(static_cast<unsigned char>(byte)) : text[i];
        if (isCode) i += 2;
    }
    return plain;
}

}  // namespace fbrdf

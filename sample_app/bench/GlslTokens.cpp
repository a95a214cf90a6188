#include "bench/GlslTokens.h"

#include <cctype>
#include <charconv>
#include <cstring>

namespace fbrdf::bench {
namespace {

bool isWord(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

bool isDigit(char c)
{
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// The end of the number or name, of the operator, or of the sign at a place.
size_t endOfToken(const std::string& text, size_t at)
{
    size_t end = at + 1;
    const bool number =
        isDigit(text[at]) || (text[at] == '.' && end < text.size() && isDigit(text[end]));
    if (number) {
        while (end < text.size() &&
               (isWord(text[end]) || text[end] == '.' ||
                ((text[end] == '-' || text[end] == '+') && std::tolower(text[end - 1]) == 'e')))
            ++end;
        return end;
    }
    if (isWord(text[at])) {
        while (end < text.size() && isWord(text[end])) ++end;
        return end;
    }
    for (const char* two : {"+=", "-=", "*=", "/=", "<=", ">=", "==", "!=", "&&", "||", "++", "--"})
        if (text.compare(at, 2, two) == 0) return at + 2;
    return end;
}

}  // namespace

std::vector<std::string> glslTokens(const std::string& text)
{
    std::vector<std::string> tokens;
    bool lineStarts = true;
    for (size_t at = 0; at < text.size();) {
        const char c = text[at];
        const bool skipped = text.compare(at, 2, "//") == 0 || (lineStarts && c == '#');
        if (skipped) {
            at = text.find('\n', at);
            if (at == std::string::npos) break;
        } else if (std::isspace(static_cast<unsigned char>(c))) {
            lineStarts = lineStarts || c == '\n';
            ++at;
        } else {
            const size_t end = endOfToken(text, at);
            tokens.push_back(text.substr(at, end - at));
            lineStarts = false;
            at = end;
        }
    }
    return tokens;
}

double glslNumber(const std::string& token)
{
    double value = 0.0;
    std::from_chars(token.data(), token.data() + token.size(), value);
    return value;
}

}  // namespace fbrdf::bench

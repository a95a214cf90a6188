#include "Text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>

namespace fbrdf {
namespace {

bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

}  // namespace

LineReader::LineReader(std::string_view text) : rest_(text)
{
    if (rest_.substr(0, 3) == "\xEF\xBB\xBF") rest_.remove_prefix(3);
}

bool LineReader::next(std::string_view& line)
{
    if (rest_.empty()) return false;
    const size_t end = std::min(rest_.find('\n'), rest_.size());
    line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    ++number_;
    return true;
}

bool LineReader::nextData(std::string_view& line)
{
    while (next(line)) {
        const std::string_view content = trimmed(line);
        if (!content.empty() && content.front() != '#') return true;
    }
    return false;
}

bool WordReader::next(std::string_view& word)
{
    size_t begin = 0;
    for (; begin < rest_.size(); ++begin) {
        const char c = rest_[begin];
        if (c == '#') begin = std::min(rest_.find('\n', begin), rest_.size()) - 1;
        if (c == '\n' || isSpace(c) || c == '#') {
            line_ += c == '\n';
            continue;
        }
        break;
    }
    rest_.remove_prefix(begin);
    if (rest_.empty()) return false;
    wordLine_ = line_;
    size_t end = 0;
    while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '#' && !isSpace(rest_[end]))
        ++end;
    word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return true;
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
    while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
    return text;
}

std::string lowerCase(std::string_view text)
{
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

void splitFields(std::string_view line, char separator, std::vector<std::string_view>& fields)
{
    fields.clear();
    for (;;) {
        const size_t end = line.find(separator);
        fields.push_back(trimmed(line.substr(0, end)));
        if (end == std::string_view::npos) return;
        line.remove_prefix(end + 1);
    }
}

void splitWords(std::string_view line, std::vector<std::string_view>& words)
{
    words.clear();
    for (size_t i = 0; i < line.size();) {
        while (i < line.size() && isSpace(line[i])) ++i;
        const size_t begin = i;
        while (i < line.size() && !isSpace(line[i])) ++i;
        if (i > begin) words.push_back(line.substr(begin, i - begin));
    }
}

bool parseNumber(std::string_view text, double& value)
{
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size()) return false;
    if (error == std::errc::result_out_of_range)  // strtod distinguishes overflow from underflow
        value = std::strtod(std::string(text).c_str(), nullptr);
    return error == std::errc() || error == std::errc::result_out_of_range;
}

bool parseInteger(std::string_view text, long long& value)
{
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

std::string quoted(std::string_view text)
{
    constexpr size_t kLongest = 40;
    std::string shown(text.substr(0, kLongest));
    for (char& c : shown)
        if (!std::isprint(static_cast<unsigned char>(c))) c = '?';
    return "'" + shown + (text.size() > kLongest ? "...'" : "'");
}

bool looksLikeText(std::string_view bytes)
{
    const std::string_view head = bytes.substr(0, 4096);
    return std::all_of(head.begin(), head.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte >= 32 || c == '\n' || isSpace(c);
    });
}

}  // namespace fbrdf

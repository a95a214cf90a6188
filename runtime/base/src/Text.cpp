#include <fbrdf/base/Text.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace fbrdf {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
/// Lines of a record with a line break in a quoted field. A quote that is still open then is a
/// character like any other, such as the sign of an inch.
constexpr size_t kMostRecordLines = 16;

bool isSpace(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

char lowerCase(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

bool hasOpenQuote(std::string_view text)
{
    return std::count(text.begin(), text.end(), '"') % 2 != 0;
}

/// Infinity or 0 for a number whose magnitude is out of the range of double.
double outOfRange(std::string_view text)
{
    const bool negative = !text.empty() && text.front() == '-';
    const size_t exponentAt = std::min(text.find_first_of("eE"), text.size());
    const std::string_view mantissa = text.substr(0, exponentAt);
    const size_t point = std::min(mantissa.find('.'), mantissa.size());
    const size_t first = mantissa.find_first_of("123456789");
    if (first == std::string_view::npos) return negative ? -0.0 : 0.0;
    long long exponent = 0;
    const bool written =
        exponentAt == text.size() || parseInteger(text.substr(exponentAt + 1), exponent);
    const auto leading = static_cast<long long>(point) - static_cast<long long>(first);
    // An exponent that does not fit long long is out of range by itself.
    const bool large = written ? exponent + leading > 0 : text[exponentAt + 1] != '-';
    const double size = large ? std::numeric_limits<double>::infinity() : 0.0;
    return negative ? -size : size;
}

}  // namespace

LineReader::LineReader(std::string_view text)
    : rest_(withoutByteOrderMark(text)), lineFeed_(std::min(rest_.find('\n'), rest_.size()))
{
}

bool LineReader::next(std::string_view& line)
{
    if (rest_.empty()) return false;
    const size_t end = std::min(rest_.substr(0, lineFeed_).find('\r'), lineFeed_);
    line = rest_.substr(0, end);
    const bool both = end < lineFeed_ && end + 1 == lineFeed_ && lineFeed_ < rest_.size();
    const size_t taken = std::min(end + (both ? 2 : 1), rest_.size());
    rest_.remove_prefix(taken);
    lineFeed_ = taken > lineFeed_ ? std::min(rest_.find('\n'), rest_.size()) : lineFeed_ - taken;
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

bool LineReader::addLine(std::string_view& record)
{
    std::string_view line;
    if (!next(line)) return false;
    record = std::string_view(record.data(), size_t(line.data() + line.size() - record.data()));
    return true;
}

bool LineReader::nextRecord(std::string_view& record)
{
    if (!nextData(record)) return false;
    if (!hasOpenQuote(record)) return true;
    const LineReader afterFirst = *this;
    const std::string_view first = record;
    for (size_t i = 1; i < kMostRecordLines && addLine(record); ++i)
        if (!hasOpenQuote(record)) return true;
    *this = afterFirst;
    record = first;
    return true;
}

WordReader::WordReader(std::string_view text) : rest_(withoutByteOrderMark(text)) {}

void WordReader::skipSpace()
{
    size_t i = 0;
    for (; i < rest_.size(); ++i) {
        if (rest_[i] == '#') i = std::min(rest_.find_first_of("\r\n", i), rest_.size());
        if (i == rest_.size()) break;
        const bool returned = rest_[i] == '\r' && rest_.substr(i + 1, 1) != "\n";
        line_ += rest_[i] == '\n' || returned;
        if (rest_[i] != '\n' && !isSpace(rest_[i])) break;
    }
    rest_.remove_prefix(std::min(i, rest_.size()));
}

bool WordReader::next(std::string_view& word)
{
    skipSpace();
    if (rest_.empty()) return false;
    wordLine_ = line_;
    size_t end = 0;
    while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '#' && !isSpace(rest_[end]))
        ++end;
    word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return true;
}

std::string_view withoutByteOrderMark(std::string_view text)
{
    if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark)
        text.remove_prefix(kByteOrderMark.size());
    return text;
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
    std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) { return lowerCase(c); });
    return lower;
}

bool sameWord(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lowerCase(x) == lowerCase(y); });
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
    if (error == std::errc::result_out_of_range) value = outOfRange(text);
    return error == std::errc() || error == std::errc::result_out_of_range;
}

bool parseLocalNumber(std::string_view text, double& value)
{
    if (parseNumber(text, value)) return true;
    const size_t comma = text.find(',');
    const bool between = comma != std::string_view::npos && comma > 0 && comma + 1 < text.size() &&
                         (isDigit(text[comma - 1]) || isDigit(text[comma + 1]));
    if (!between || text.find_first_of(",.", comma + 1) != std::string_view::npos) return false;
    std::string pointed(text);
    pointed[comma] = '.';
    return parseNumber(pointed, value);
}

bool parseInteger(std::string_view text, long long& value)
{
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

std::string inQuotes(std::string_view text)
{
    constexpr size_t kLongest = 40;
    std::string shown(text.substr(0, kLongest));
    for (char& c : shown)
        if (c < ' ' || c > '~') c = '?';
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

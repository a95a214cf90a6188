#include "PairRows.h"

#include <fbrdf/base/Error.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace fbrdf::tool {
namespace {

constexpr int kUnused = -1;
constexpr std::array<std::string_view, 6> kNames{"wo_x", "wo_y", "wo_z", "wi_x", "wi_y", "wi_z"};
constexpr size_t kShown = 60;  // characters of a field in a message

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kSpace = " \t\r";
    const size_t begin = text.find_first_not_of(kSpace);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kSpace) - begin + 1);
}

// Takes the field before the next comma off the text, and the comma with it.
std::string_view takeField(std::string_view& line)
{
    const size_t comma = line.find(',');
    const std::string_view field = trimmed(line.substr(0, comma));
    line.remove_prefix(comma == std::string_view::npos ? line.size() : comma + 1);
    return field;
}

int componentNamed(std::string_view field)
{
    std::string name(field);
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    return found == kNames.end() ? kUnused : static_cast<int>(found - kNames.begin());
}

bool parseNumber(std::string_view text, double& value)
{
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, value);
    return parsed.ec == std::errc() && parsed.ptr == end && std::isfinite(value);
}

// The vector is scaled by its largest component first, because the square of a huge or tiny one
// would overflow or vanish.
bool normalise(Vec3d& v)
{
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0.0)) return false;
    v = glm::normalize(v / largest);
    return true;
}

// Bytes that are not printable ASCII become '?': a header may be anything, even a picture.
std::string quoted(std::string_view text)
{
    std::string shown(text.substr(0, kShown));
    for (char& c : shown)
        if (c < ' ' || c > '~') c = '?';
    return "'" + shown + (text.size() > kShown ? "..." : "") + "'";
}

size_t countFields(std::string_view line)
{
    return static_cast<size_t>(std::count(line.begin(), line.end(), ',')) + 1;
}

}  // namespace

std::string_view takeLine(std::string_view& text)
{
    const size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

bool isSkipped(std::string_view line)
{
    const size_t first = line.find_first_not_of(" \t\r");
    return first == std::string_view::npos || line[first] == '#';
}

std::string_view withoutByteOrderMark(std::string_view line)
{
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (line.substr(0, kByteOrderMark.size()) == kByteOrderMark)
        line.remove_prefix(kByteOrderMark.size());
    return line;
}

PairRows::PairRows(std::string_view header, const std::string& where)
{
    header = withoutByteOrderMark(header);
    const size_t fields = countFields(header);
    for (std::string_view rest = header; componentOfField_.size() < fields;)
        componentOfField_.push_back(componentNamed(takeField(rest)));
    for (int c = 0; c < 6; ++c)
        if (std::count(componentOfField_.begin(), componentOfField_.end(), c) != 1)
            throw Error(ErrorKind::input, where,
                        "found the header " + quoted(header) +
                            ", expected wo_x,wo_y,wo_z,wi_x,wi_y,wi_z, each once");
}

std::string PairRows::parse(std::string_view line, DirectionPair<double>& pair) const
{
    const size_t fields = countFields(line);
    if (fields != componentOfField_.size())
        return "found " + std::to_string(fields) + " fields, expected " +
               std::to_string(componentOfField_.size()) + " as in the header";
    std::array<double, 6> v{};
    for (const int component : componentOfField_) {
        const std::string_view field = takeField(line);
        if (component != kUnused && !parseNumber(field, v[static_cast<size_t>(component)]))
            return "found " + quoted(field) + " as " +
                   std::string(kNames[static_cast<size_t>(component)]) +
                   ", expected a finite number";
    }
    pair.wo = {v[0], v[1], v[2]};
    pair.wi = {v[3], v[4], v[5]};
    if (!normalise(pair.wo) || !normalise(pair.wi))
        return "found a direction of length 0, expected any other length";
    return {};
}

}  // namespace fbrdf::tool

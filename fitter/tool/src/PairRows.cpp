#include "PairRows.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/Text.h>

#include <algorithm>
#include <cmath>

namespace fbrdf::tool {
namespace {

constexpr int kUnused = -1;
constexpr std::array<std::string_view, 6> kNames{"wo_x", "wo_y", "wo_z", "wi_x", "wi_y", "wi_z"};

int componentNamed(std::string_view field)
{
    const auto found = std::find(kNames.begin(), kNames.end(), lowerCase(field));
    return found == kNames.end() ? kUnused : static_cast<int>(found - kNames.begin());
}

bool parseFinite(std::string_view text, double& value)
{
    return parseLocalNumber(text, value) && std::isfinite(value);
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

PairRows::PairRows(std::string_view header, const std::string& where)
    : separator_(separatorOfNames(header))
{
    FieldReader fields(header, separator_);
    for (std::string_view field; fields.next(field);)
        componentOfField_.push_back(componentNamed(field));
    for (int c = 0; c < 6; ++c)
        if (std::count(componentOfField_.begin(), componentOfField_.end(), c) != 1)
            throw Error(ErrorKind::input, where,
                        Found("the header " + inQuotes(header))
                            .expected("wo_x,wo_y,wo_z,wi_x,wi_y,wi_z, each once"));
}

std::string PairRows::parse(std::string_view line, DirectionPair<double>& pair) const
{
    std::array<double, 6> v{};
    FieldReader fields(line, separator_);
    size_t count = 0;
    std::string wrong;
    for (std::string_view field; fields.next(field); ++count) {
        const int component = count < componentOfField_.size() ? componentOfField_[count] : kUnused;
        if (component != kUnused && wrong.empty() &&
            !parseFinite(field, v[static_cast<size_t>(component)]))
            wrong = Found(inQuotes(field) + " as " +
                          std::string(kNames[static_cast<size_t>(component)]))
                        .expected("a finite number");
    }
    if (count != componentOfField_.size())
        return Found(std::to_string(count) + " fields")
            .expected(std::to_string(componentOfField_.size()) + " as in the header");
    if (!wrong.empty()) return wrong;
    pair.wo = {v[0], v[1], v[2]};
    pair.wi = {v[3], v[4], v[5]};
    if (!normalise(pair.wo) || !normalise(pair.wi))
        return Found("a direction of length 0").expected("any other length");
    return {};
}

}  // namespace fbrdf::tool

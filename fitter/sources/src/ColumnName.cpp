#include "ColumnName.h"

#include <fbrdf/base/Text.h>
#include <fbrdf/brdf/Conventions.h>

#include <algorithm>
#include <array>

namespace fbrdf {
namespace {

constexpr std::array<std::string_view, 5> kDegreeNames = {"deg", "degree", "degrees", "\xC2\xB0",
                                                          "\xB0"};
constexpr std::array<std::string_view, 3> kRadianNames = {"rad", "radian", "radians"};

template <size_t N>
bool contains(const std::array<std::string_view, N>& names, std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

ColumnName columnNameOf(std::string_view name)
{
    const std::string lower = lowerCase(trimmed(name));
    const size_t open = lower.find_first_of("[(");
    if (open != std::string::npos && open > 0) {
        const size_t close = lower.find_first_of("])", open);
        const std::string_view text = lower;
        return {std::string(trimmed(text.substr(0, open))),
                std::string(trimmed(text.substr(open + 1, close - open - 1)))};
    }
    for (const std::string_view unit : {"_deg", "_degrees", "_rad", "_radians"})
        if (lower.size() > unit.size() && lower.substr(lower.size() - unit.size()) == unit)
            return {lower.substr(0, lower.size() - unit.size()), std::string(unit.substr(1))};
    return {lower, ""};
}

std::optional<double> degreesIn(const std::string& unit, double unnamed)
{
    if (unit.empty()) return unnamed;
    if (contains(kDegreeNames, unit)) return 1.0;
    if (contains(kRadianNames, unit)) return 180.0 / kPi;
    return {};
}

}  // namespace fbrdf

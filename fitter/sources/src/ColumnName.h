// ColumnName.h - the name of a column and the unit that stands in it: "theta_i [rad]",
// "theta_i (deg)", "theta_i_deg".
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace fbrdf {

struct ColumnName {
    std::string base;  ///< lower case, without the unit
    std::string unit;  ///< lower case, empty where the name has none
};

ColumnName columnNameOf(std::string_view name);

/// Degrees in a unit of angles: "deg", "degrees", "rad" and so on; `unnamed` for the empty unit.
/// Nothing for a unit that is not one of angles.
std::optional<double> degreesIn(const std::string& unit, double unnamed = 1.0);

}  // namespace fbrdf

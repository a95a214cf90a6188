// CsvText.h - one line of a table in comma-separated values. Reference: RFC 4180.
#pragma once
#include <string>
#include <vector>

namespace fbrdf::tool {

/// The fields on one line, newline included; a field with a comma, a quote or a line break is
/// quoted.
std::string csvLine(const std::vector<std::string>& fields);

/// The inverse of csvLine. Expects a `line` without its newline; no field may contain a line break.
std::vector<std::string> csvFields(const std::string& line);

}  // namespace fbrdf::tool

// Html.h - text, numbers and bytes in the form that the page needs.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace fbrdf {

/// Any bytes as character data or a quoted attribute: markup escaped, invalid UTF-8 and characters
/// that XML 1.0 does not allow replaced by U+FFFD.
std::string escaped(const std::string& text);

/// Three significant digits: "0.0123", "57.3", "12,400", "1.2e-05"; NaN is an en dash, infinity its
/// sign.
std::string number(double value);
/// At most three significant digits, no trailing zeros: for axes. "0.5", "10", "1e-05".
std::string shortNumber(double value);
/// Digits in groups of three: "1,458,000".
std::string grouped(uint64_t value);

/// Base64 as in RFC 4648, section 4.
std::string base64(const std::vector<uint8_t>& bytes);

/// <name attributes>content</name>; content and attributes are markup already.
std::string element(const std::string& name, const std::string& attributes,
                    const std::string& content);

}  // namespace fbrdf

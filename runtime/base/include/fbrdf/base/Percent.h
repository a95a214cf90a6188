// Percent.h - text as one word of plain characters, as in addresses of the web (RFC 3986): names
// with spaces and separators get through options and files that end words there.
#pragma once
#include <string>
#include <string_view>

namespace fbrdf {

/// Every byte but letters, digits, '.', '_', '-' and '~' becomes '%' and two hexadecimal digits.
std::string percentEncoded(std::string_view text);
/// The inverse. A '%' without two hexadecimal digits behind it stays as it is.
std::string percentDecoded(std::string_view text);

}  // namespace fbrdf

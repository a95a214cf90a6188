#include <fbrdf/base/Number.h>

#include <array>
#include <charconv>

namespace fbrdf {
namespace {

/// The largest double has 309 digits before the point.
constexpr size_t kLongestNumber = 400;

std::string textOf(double value, std::chars_format format, int precision)
{
    std::array<char, kLongestNumber> text;
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), value, format, precision);
    return error == std::errc() ? std::string(text.data(), end) : std::string("number");
}

}  // namespace

std::string numberText(double value, int digits)
{
    return textOf(value, std::chars_format::general, digits);
}

std::string fixedText(double value, int decimals)
{
    return textOf(value, std::chars_format::fixed, decimals);
}

}  // namespace fbrdf

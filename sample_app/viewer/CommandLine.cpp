#include "CommandLine.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

#include <fmt/core.h>

#include <charconv>
#include <exception>

namespace fbrdf::viewer {

Size sizeFromText(const std::string& text)
{
    constexpr int kLargestSide = 16384;  // what GL 3.3 implementations commonly render to
    Size size;
    const char* const end = text.data() + text.size();
    const auto [cross, error] = std::from_chars(text.data(), end, size.width);
    const bool hasCross = error == std::errc() && cross != end && *cross == 'x';
    const auto [last, error2] = std::from_chars(hasCross ? cross + 1 : end, end, size.height);
    const auto inRange = [](int side) { return side >= 1 && side <= kLargestSide; };
    if (!hasCross || error2 != std::errc() || last != end || !inRange(size.width) ||
        !inRange(size.height))
        throw Error(
            ErrorKind::usage, "--size",
            Found("'" + text + "'").expected("WxH of 1 to " + std::to_string(kLargestSide)));
    return size;
}

int exitCodeOf(const char* program, int (*run)(int, char**), int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const Error& error) {
        fmt::print(stderr, "{}: {}\n", program, error.what());
        return static_cast<int>(error.kind());
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}: unexpected: {}\n", program, error.what());
        return 1;
    }
}

}  // namespace fbrdf::viewer

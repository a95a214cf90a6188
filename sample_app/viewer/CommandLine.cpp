#include "CommandLine.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/headless/Context.h>

#include <fmt/core.h>

#include <charconv>
#include <exception>
#include <vector>

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

std::optional<int> deviceFromText(const std::string& text)
{
    constexpr int kMostDevices = 1000;
    if (text.empty()) return {};
    int number = 0;
    const auto [last, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || last != text.data() + text.size() || number < 0 ||
        number > kMostDevices)
        throw Error(ErrorKind::usage, "--device",
                    Found("'" + text + "'").expected("the number of a device, or list"));
    return number;
}

const char* deviceHelp()
{
    return "The device of EGL to draw with, by its number; list prints them (default: that of "
           "Mesa's surfaceless platform)";
}

std::string devicesText()
{
    const std::vector<std::string> devices = headlessDevices();
    std::string text;
    for (size_t i = 0; i < devices.size(); ++i) text += fmt::format("{}  {}\n", i, devices[i]);
    return text.empty() ? "EGL lists no devices here\n" : text;
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

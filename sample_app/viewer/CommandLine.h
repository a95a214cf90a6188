// CommandLine.h - what the programs of this folder share: sizes, and how they end.
#pragma once
#include <optional>
#include <string>

namespace fbrdf::viewer {

/// Pixels of "640x480"; throws Error(usage) naming --size unless both are in [1, 16384].
struct Size {
    int width = 0, height = 0;
};
Size sizeFromText(const std::string& text);

/// What --device takes: a number of headlessDevices(), or "" for none. Throws Error(usage).
std::optional<int> deviceFromText(const std::string& text);
const char* deviceHelp();
/// One line for each of headlessDevices().
std::string devicesText();

/// Returns run(argc, argv). Where that throws, prints one line to stderr and returns the exit code
/// of Error.h, or 1 for any other exception.
int exitCodeOf(const char* program, int (*run)(int, char**), int argc, char** argv);

}  // namespace fbrdf::viewer

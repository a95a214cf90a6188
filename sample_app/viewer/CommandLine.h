// CommandLine.h - what the programs of this folder share: sizes, and how they end.
#pragma once
#include <string>

namespace fbrdf::viewer {

/// Pixels of "640x480"; throws Error(usage) naming --size unless both are in [1, 16384].
struct Size {
    int width = 0, height = 0;
};
Size sizeFromText(const std::string& text);

/// Returns run(argc, argv). Where that throws, prints one line to stderr and returns the exit code
/// of Error.h, or 1 for any other exception.
int exitCodeOf(const char* program, int (*run)(int, char**), int argc, char** argv);

}  // namespace fbrdf::viewer

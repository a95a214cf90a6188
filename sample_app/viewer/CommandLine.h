// CommandLine.h - what the programs of this folder share: sizes, and how they end.
#pragma once
#include <string>

namespace fbrdf::viewer {

/// Pixels of "640x480"; throws Error(usage) naming --size unless both are in [1, 16384].
struct Size {
    int width = 0, height = 0;
};
Size sizeFromText(const std::string& text);

/// run(argc, argv), or for what it throws one line on stderr and the exit code that Error.h says;
/// 1 for what should not happen.
int exitCodeOf(const char* program, int (*run)(int, char**), int argc, char** argv);

}  // namespace fbrdf::viewer

// BatchList.h - the list of materials that `batch` fits: one "name<TAB>source" a line; blank lines
// and lines that start with '#' are skipped.
#pragma once
#include <string>
#include <vector>

namespace fbrdf::tool {

struct BatchItem {
    std::string name;    ///< of the file NAME.fbrdf in the output folder
    std::string source;  ///< as on the command line of `fit`
};

/// Reads the whole file. Throws Error(input).
std::string readListFile(const std::string& path);

/// Throws Error(input) with `path` and line for a line without a tab, for a name that is no plain
/// file name or occurs twice, and for an empty list.
std::vector<BatchItem> parseList(const std::string& text, const std::string& path);

}  // namespace fbrdf::tool

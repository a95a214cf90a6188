// UsageMessage.h - rewrites the parser's complaints about a command line as errors of the tool.
#pragma once
#include <CLI/CLI.hpp>

#include <string>

namespace fbrdf::tool {

/// "fit: found no SOURCE, expected one; see fbrdf fit --help". `first`: the first argument, or
/// null.
std::string usageMessage(const CLI::App& app, const CLI::ParseError& error, const char* first);

}  // namespace fbrdf::tool

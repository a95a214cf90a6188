// UsageMessage.h - what the parser says of a wrong command line, in the words of the tool's errors.
#pragma once
#include <CLI/CLI.hpp>

#include <string>

namespace fbrdf::tool {

/// "fit: found no SOURCE, expected one; see fbrdf fit --help". `first`: the first argument, or
/// null.
std::string usageMessage(const CLI::App& app, const CLI::ParseError& error, const char* first);

}  // namespace fbrdf::tool

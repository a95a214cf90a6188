#include "UsageMessage.h"

#include <fbrdf/base/Found.h>

namespace fbrdf::tool {
namespace {

std::string commandNames(const CLI::App& app)
{
    std::string names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names += (names.empty() ? "" : ", ") + command->get_name();
    return names;
}

// Finds what is wrong in the parser's own words: "SOURCE is required", "The following argument was
// not expected: X", "--form: 1 required FORM missing".
std::string complaint(const CLI::ParseError& error)
{
    const auto code = static_cast<CLI::ExitCodes>(error.get_exit_code());
    const std::string words = error.what();
    const size_t required = words.find(" is required"), colon = words.find(": ");
    if (code == CLI::ExitCodes::RequiredError && required != std::string::npos)
        return Found("no " + words.substr(0, required)).expected("one");
    if (code == CLI::ExitCodes::ExtrasError && colon != std::string::npos)
        return Found("'" + words.substr(colon + 2) + "'").expected("no such argument");
    if (code == CLI::ExitCodes::ArgumentMismatch && colon != std::string::npos)
        return "found " + words.substr(0, colon) +
               (words.find("received") != std::string::npos ? " again, expected it once"
                                                            : " alone, expected a value after it");
    return words;
}

}  // namespace

std::string usageMessage(const CLI::App& app, const CLI::ParseError& error, const char* first)
{
    const auto used = app.get_subcommands();
    if (used.empty())
        return std::string("command line: found ") +
               (first ? "'" + std::string(first) + "'" : "no command") + ", expected one of " +
               commandNames(app) + "; see fbrdf --help";
    const std::string name = used.front()->get_name();
    return name + ": " + complaint(error) + "; see fbrdf " + name + " --help";
}

}  // namespace fbrdf::tool

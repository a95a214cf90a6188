// fbrdf: parses the command line, runs one command, and turns errors into one line and an exit
// code.
#include "src/Commands.h"
#include "src/Output.h"
#include "src/UsageMessage.h"
#include "src/Version.h"

#include <fbrdf/base/ClassicLocale.h>
#include <fbrdf/base/Error.h>

#include <cstdio>
#include <new>

namespace {

using fbrdf::ErrorKind;

int report(ErrorKind kind, const std::string& message)
{
    std::fprintf(stderr, "fbrdf: %s\n", fbrdf::tool::oneLine(message).c_str());
    return static_cast<int>(kind);
}

void describeTool(CLI::App& app)
{
    app.description("Factors measured and analytic BRDFs into small positive maps.");
    app.set_version_flag("--version", std::string("fbrdf ") + fbrdf::tool::kVersion);
    app.require_subcommand(1);
    app.footer(
        "SOURCE is a file, or a model as in ggx:alpha=0.1,f0=1/0.8/0.5 (see fbrdf models). Of\n"
        "pab's gonio-photometer, whose files have one direction of the light each, it is\n"
        "their folder.\n"
        "Exit codes: 0 done, 1 a check did not hold, 2 bad usage, 3 invalid input, 4 fit failed,\n"
        "5 output could not be written, 6 no usable GL.");
}

void addCommands(CLI::App& app, fbrdf::tool::Action& action)
{
    using namespace fbrdf::tool;
    addFitCommand(app, action);
    addEvalCommand(app, action);
    addCompareCommand(app, action);
    addInfoCommand(app, action);
    addConvertCommand(app, action);
    addBatchCommand(app, action);
    addBenchFitCommand(app, action);
    addModelsCommand(app, action);
    addFormsCommand(app, action);
    addGlslCommand(app, action);
    addPlanSamplesCommand(app, action);
    addSampleCommand(app, action);
    addPdfCommand(app, action);
    addLearnPriorCommand(app, action);
}

// The parser throws for --help and --version, too; they are no failures.
int reportParse(const CLI::App& app, const CLI::ParseError& error, const char* first)
{
    if (error.get_exit_code() != 0)
        return report(ErrorKind::usage, fbrdf::tool::usageMessage(app, error, first));
    const auto used = app.get_subcommands();
    const bool version = error.get_name() == "CallForVersion";
    const std::string help = used.empty() ? app.help() : used.front()->help(app.get_name());
    fbrdf::tool::writeOut(version ? std::string(error.what()) + "\n" : help);
    return 0;
}

int parseAndRun(int argc, char** argv)
{
    CLI::App app("", "fbrdf");
    fbrdf::tool::Action action;
    describeTool(app);
    addCommands(app, action);
    try {
        const fbrdf::ClassicLocale numbers;
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return reportParse(app, error, argc > 1 ? argv[1] : nullptr);
    }
    return action();
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        return parseAndRun(argc, argv);
    } catch (const fbrdf::Error& error) {
        return report(error.kind(), error.what());
    } catch (const std::bad_alloc&) {
        return report(ErrorKind::input, "memory: found too little, expected less data");
    } catch (const std::exception& error) {
        return report(ErrorKind::input, std::string("unexpected: ") + error.what());
    }
}

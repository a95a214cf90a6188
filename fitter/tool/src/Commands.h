// Commands.h - the commands of the tool. Each adds itself to the command line; parsing sets
// `action` to what was asked for, bound to its options, and main() runs it.
#pragma once
#include <CLI/CLI.hpp>

#include <functional>

namespace fbrdf::tool {

/// Runs a command; returns the exit code 0, or 1 for a check that did not hold. Throws Error.
using Action = std::function<int()>;

void addFitCommand(CLI::App& app, Action& action);
void addEvalCommand(CLI::App& app, Action& action);
void addCompareCommand(CLI::App& app, Action& action);
void addInfoCommand(CLI::App& app, Action& action);
void addConvertCommand(CLI::App& app, Action& action);
void addBatchCommand(CLI::App& app, Action& action);
void addBenchFitCommand(CLI::App& app, Action& action);
void addModelsCommand(CLI::App& app, Action& action);
void addFormsCommand(CLI::App& app, Action& action);
void addGlslCommand(CLI::App& app, Action& action);
void addPlanSamplesCommand(CLI::App& app, Action& action);
void addSampleCommand(CLI::App& app, Action& action);
void addPdfCommand(CLI::App& app, Action& action);
void addLearnPriorCommand(CLI::App& app, Action& action);

}  // namespace fbrdf::tool

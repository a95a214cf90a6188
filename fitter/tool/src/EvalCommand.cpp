// fbrdf eval: values at direction pairs, CSV in, CSV or JSON out, as a stream.
#include "Arguments.h"
#include "Commands.h"
#include "EvalStream.h"
#include "Output.h"
#include "Progress.h"
#include "Reflectance.h"

#include <unistd.h>

namespace fbrdf::tool {
namespace {

struct EvalCommand {
    std::string source, pairs;
    SourceOptions sourceOptions;
    bool exact = false, json = false;
    int threads = 0;
};

// A bar would mix with rows on the same terminal.
bool showsProgress()
{
    return !isatty(STDOUT_FILENO);
}

int run(const EvalCommand& command)
{
    const Reflectance opened =
        openReflectance(command.source, command.sourceOptions,
                        command.exact ? Precision::exact : Precision::shader);
    requireFunction(opened, command.source);
    LineBlocks blocks(command.pairs);
    Progress progress(showsProgress());
    bool any = false;
    EvalRequest request{
        opened.brdf, command.json ? RowStyle::json : RowStyle::csv, command.threads, {}};
    request.write = [&](std::string_view rows) {
        if (!any) writeOut(command.json ? "[\n" : "r,g,b\n");
        if (any && command.json) writeOut(",\n");
        any = true;
        writeOut(rows);
        progress.bar(blocks.bytesRead(), blocks.size(), "evaluating");
    };
    evaluateStream(blocks, request);
    if (!any) writeOut(command.json ? "[\n" : "r,g,b\n");
    if (command.json) writeOut(any ? "\n]\n" : "]\n");
    return 0;
}

}  // namespace

void addEvalCommand(CLI::App& app, Action& action)
{
    CLI::App* sub = app.add_subcommand("eval", "values at direction pairs");
    const auto command = std::make_shared<EvalCommand>();
    sub->add_option("SOURCE", command->source, "material, file, or model NAME:key=value,...")
        ->required();
    sub->add_option("--pairs", command->pairs,
                    "CSV with columns wo_x,wo_y,wo_z,wi_x,wi_y,wi_z; - is standard input")
        ->required()
        ->type_name("FILE|-");
    sub->add_flag("--exact", command->exact, "materials in double, not in float as the shader");
    sub->add_flag("--json", command->json, "a JSON array of [r,g,b] rows, as a stream");
    addCosine(*sub, command->sourceOptions);
    addThreads(*sub, command->threads);
    sub->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace fbrdf::tool

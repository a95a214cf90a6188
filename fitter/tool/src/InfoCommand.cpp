// fbrdf info: what a material or a data file contains.
#include "Arguments.h"
#include "Commands.h"
#include "DataInfo.h"
#include "MaterialInfo.h"
#include "Output.h"
#include "Progress.h"

namespace fbrdf::tool {
namespace {

struct InfoCommand {
    std::string source;
    SourceOptions sourceOptions;
    bool json = false;
    int threads = 0;
};

int run(const InfoCommand& command)
{
    Progress progress(true);
    progress.phase("reading " + command.source);
    const Reflectance opened =
        openReflectance(command.source, command.sourceOptions, Precision::shader);
    std::string result;
    if (opened.material) {
        const MaterialInfo info = materialInfo(opened, command.threads);
        result = command.json ? text(jsonOf(info)) : textOf(info);
    } else {
        const DataInfo info = dataInfo(opened.source, command.threads);
        result = command.json ? text(jsonOf(info)) : textOf(info);
    }
    progress.clear();
    writeOut(result);
    return 0;
}

}  // namespace

void addInfoCommand(CLI::App& app, Action& action)
{
    CLI::App* sub = app.add_subcommand("info", "what a material or a data file contains");
    const auto command = std::make_shared<InfoCommand>();
    sub->add_option("FILE", command->source, "material, data file, or model")->required();
    sub->add_flag("--json", command->json, "print one JSON object");
    addCosine(*sub, command->sourceOptions);
    addThreads(*sub, command->threads);
    sub->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace fbrdf::tool

// fbrdf learn-prior: known materials in, a prior for fits to few samples out.
#include "Arguments.h"
#include "Commands.h"
#include "Progress.h"

#include <fbrdf/base/OutputFile.h>
#include <fbrdf/fit/SamplePlan.h>
#include <fbrdf/sources/OpenSource.h>

#include <memory>

namespace fbrdf::tool {
namespace {

struct LearnPriorCommand {
    std::vector<std::string> sources;
    std::string output, plan, planInPlane;
    int modes = 32, threads = 0;
    size_t planned = 2048;
    bool quiet = false;
};

void addPlan(const LearnPriorCommand& command, const std::string& path, PlanSpace space,
             const TablePrior& prior, const KnownMaterials& known, Progress& progress,
             OutputFiles& files)
{
    if (path.empty()) return;
    progress.phase("planning " + path);
    files.add(path, planText(planSamples(prior, known, space, command.planned)));
}

int run(const LearnPriorCommand& command)
{
    for (const std::string& path : {command.output, command.plan, command.planInPlane})
        if (!path.empty()) requireWritable(path);
    Progress progress(!command.quiet);
    std::vector<Source> functions;
    for (const std::string& source : command.sources) {
        progress.phase("reading " + source);
        functions.push_back(openSource(source));
    }
    progress.phase("fitting " + std::to_string(functions.size()) + " materials");
    const KnownMaterials known = knownMaterials(functions, command.threads);
    const TablePrior prior = learnTablePrior(known, command.modes);
    OutputFiles files;
    files.add(command.output, tablePriorBytes(prior));
    addPlan(command, command.plan, PlanSpace::hemisphere, prior, known, progress, files);
    addPlan(command, command.planInPlane, PlanSpace::planeOfIncidence, prior, known, progress,
            files);
    files.commit();
    progress.clear();
    return 0;
}

}  // namespace

void addLearnPriorCommand(CLI::App& app, Action& action)
{
    CLI::App* sub = app.add_subcommand("learn-prior", "what fits to few samples lean on");
    const auto command = std::make_shared<LearnPriorCommand>();
    sub->add_option("SOURCE", command->sources,
                    "known materials: files or models that are functions")
        ->required();
    sub->add_option("-o,--output", command->output, "prior to write, for fit --prior")
        ->required()
        ->type_name("FILE");
    addInteger(*sub, "--modes", command->modes, 1, 1024, "principal components; default 32")
        ->type_name("N");
    sub->add_option("--plan", command->plan, "directions to measure, best first")
        ->type_name("FILE.csv");
    sub->add_option("--plan-in-plane", command->planInPlane, "the same in the plane of incidence")
        ->type_name("FILE.csv");
    addInteger(*sub, "--planned", command->planned, 1, 5000, "directions of a plan; default 2048")
        ->type_name("N");
    addThreads(*sub, command->threads);
    sub->add_flag("--quiet", command->quiet, "print nothing but errors");
    sub->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace fbrdf::tool

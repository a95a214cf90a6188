// fbrdf bench-fit: many materials, our forms and the peers, one table.
#include "Arguments.h"
#include "bench/AreaBench.h"
#include "bench/BenchCsv.h"
#include "bench/BenchSummary.h"
#include "bench/EnvironmentBench.h"
#include "bench/SamplingBench.h"
#include "Commands.h"
#include "Output.h"
#include "Robustness.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/sources/OpenSource.h>

#include <algorithm>
#include <functional>

namespace fbrdf::tool {
namespace {

struct BenchFitCommand {
    std::vector<std::string> sources;
    std::string forms = "hdpio:3900,hdpio:1400,hdpu:3900,hdpu:1400,u+hdpu:8192", peers = "all", csv;
    std::string environment;  ///< folder; empty: point lights
    EnvironmentBenchOptions environments;
    BenchOptions options;
    bool resume = false, json = false, robustness = false, sampling = false, areaLights = false;
};

std::vector<std::string> expanded(const std::vector<std::string>& sources)
{
    std::vector<std::string> all;
    for (const std::string& source : sources)
        for (const std::string& material : materialsOf(source)) all.push_back(material);
    return all;
}

// A material that cannot be read or fitted must not lose the results of the others.
MaterialScores scoresOrError(const std::string& source, const BenchOptions& options,
                             Progress& progress)
{
    try {
        return scoreMaterial(source, options, progress);
    } catch (const Error& error) {
        return {source, source, {}, oneLine(error.what())};
    }
}

// The table is written anew after every material, so that a run that is ended early loses one.
std::vector<MaterialScores> allScores(const BenchFitCommand& command)
{
    const std::vector<Contender>& contenders = command.options.contenders;
    const auto known =
        command.resume ? scoresFromCsv(command.csv, contenders) : std::vector<MaterialScores>();
    Progress progress(true);
    std::vector<MaterialScores> materials;
    for (const std::string& source : expanded(command.sources)) {
        const auto found = std::find_if(known.begin(), known.end(), [&](const MaterialScores& m) {
            return m.source == source;
        });
        materials.push_back(found == known.end() ? scoresOrError(source, command.options, progress)
                                                 : *found);
        if (!command.csv.empty()) writeFile(command.csv, benchCsv(materials, contenders));
    }
    progress.clear();
    return materials;
}

// Fits our forms alone to worse and worse data. Returns 1 where they lose more than they may.
int runRobustness(BenchFitCommand& command)
{
    command.options.contenders = contendersFrom(command.forms, "none");
    Progress progress(true);
    std::vector<RobustScore> scores;
    for (const std::string& source : expanded(command.sources))
        for (RobustScore& score : robustness(source, command.options, progress))
            scores.push_back(std::move(score));
    progress.clear();
    writeOut(command.json ? text(robustnessJson(scores)) : robustnessText(scores));
    return allHold(scores) ? 0 : 1;
}

// Returns 1 where a material has no answer.
int runEnvironment(const BenchFitCommand& command)
{
    EnvironmentBenchOptions options = command.environments;
    options.threads = command.options.fit.threads;
    options.source = command.options.source;
    const auto environments = environmentsOf(command.environment);
    Progress progress(true);
    const auto scores =
        scoreEnvironments(expanded(command.sources), environments, options, progress);
    progress.clear();
    writeOut(command.json ? text(environmentJson(scores, environments))
                          : environmentText(scores, environments));
    const auto failed = [](const EnvironmentScores& m) { return !m.error.empty(); };
    return std::any_of(scores.begin(), scores.end(), failed) ? 1 : 0;
}

int runAreaLights(const BenchFitCommand& command)
{
    AreaBenchOptions options;
    options.size = command.environments.size;
    options.threads = command.options.fit.threads;
    options.source = command.options.source;
    Progress progress(true);
    const auto scores = scoreAreaLights(expanded(command.sources), options, progress);
    progress.clear();
    writeOut(command.json ? text(areaJson(scores)) : areaText(scores));
    const auto failed = [](const AreaScores& m) { return !m.error.empty(); };
    return std::any_of(scores.begin(), scores.end(), failed) ? 1 : 0;
}

// Returns 1 where the best diffuse and GGX have less variance than our lobes, or a material has no
// answer.
int runSampling(const BenchFitCommand& command)
{
    const std::vector<Contender> forms = contendersFrom(command.forms, "none");
    Progress progress(true);
    const auto scores =
        scoreSampling(expanded(command.sources), forms.front(), command.options, progress);
    progress.clear();
    writeOut(command.json ? text(samplingJson(scores)) : samplingText(scores));
    return std::all_of(scores.begin(), scores.end(), std::mem_fn(&SamplingScore::isLower)) ? 0 : 1;
}

std::string leftOutText(const BenchFitCommand& command)
{
    return command.peers == "all" && !peersLeftOut().empty() ? "left out: " + peersLeftOut() + "\n"
                                                             : "";
}

int run(BenchFitCommand& command)
{
    if (command.robustness) return runRobustness(command);
    if (command.sampling) return runSampling(command);
    if (!command.environment.empty()) return runEnvironment(command);
    if (command.areaLights) return runAreaLights(command);
    command.options.contenders = contendersFrom(command.forms, command.peers);
    command.options.peers.threads = command.options.fit.threads;
    command.options.peers.seed = command.options.fit.seed;
    if (command.resume && command.csv.empty())
        throw Error(ErrorKind::usage, "--resume",
                    Found("no --csv").expected("the table to go on from"));
    if (!command.csv.empty()) requireWritable(command.csv);
    const std::vector<MaterialScores> materials = allScores(command);
    writeOut(command.json ? text(benchJson(materials))
                          : benchText(materials) + leftOutText(command));
    return std::any_of(materials.begin(), materials.end(),
                       [](const MaterialScores& m) { return !m.error.empty(); })
               ? 1
               : 0;
}

}  // namespace

void addBenchFitCommand(CLI::App& app, Action& action)
{
    CLI::App* sub =
        app.add_subcommand("bench-fit", "compare forms and other representations on many sources");
    const auto command = std::make_shared<BenchFitCommand>();
    command->options.peers.dataDir = publishedDataDir();
    sub->add_option("SOURCES", command->sources,
                    "files or models; a collection FILE or FILE#set stands for all its materials")
        ->required();
    sub->add_option("--forms", command->forms,
                    "our forms, FORM or FORM:BYTES for a budget, separated by commas")
        ->type_name("F,..")
        ->capture_default_str();
    sub->add_option("--peers", command->peers, "names separated by commas, all, or none")
        ->type_name("P,..")
        ->capture_default_str();
    sub->add_option("--data", command->options.peers.dataDir,
                    "folder of published parameters (merl_fits, npf_merl)")
        ->type_name("DIR")
        ->capture_default_str();
    addFitTuning(*sub, command->options.fit);
    addCosine(*sub, command->options.source);
    sub->add_option("--csv", command->csv,
                    "also write a row for each material and contender, after every material")
        ->type_name("FILE");
    sub->add_flag("--resume", command->resume,
                  "keep the materials that the table of --csv has for all of the contenders");
    sub->add_flag("--robustness", command->robustness,
                  "instead: what our forms lose to noise, zeros, spikes and few samples");
    sub->add_flag(
        "--sampling", command->sampling,
        "instead: the variance of directions that are drawn from the lobes of the first of "
        "our forms, and of the best diffuse + GGX");
    sub->add_option("--environment", command->environment,
                    "instead: light from every .exr and .hdr of a folder, by lobes and by the best "
                    "split sum")
        ->type_name("DIR");
    sub->add_flag("--area-lights", command->areaLights,
                  "instead: light from spheres and rectangles, by lobes");
    addInteger(*sub, "--environment-size", command->environments.size, 8, 512,
               "pixels across the sphere of --environment and --area-lights (64)")
        ->type_name("N");
    sub->add_flag("--json", command->json, "print one JSON object");
    sub->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace fbrdf::tool

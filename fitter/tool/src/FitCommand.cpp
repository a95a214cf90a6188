// fbrdf fit: reflectance in, a material out.
#include "Arguments.h"
#include "Commands.h"
#include "FitJob.h"
#include "FitReport.h"
#include "LobeInfo.h"
#include "Output.h"
#include "Ranks.h"
#include "TextTable.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/base/OutputFile.h>
#include <fbrdf/io/MaterialFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace fbrdf::tool {
namespace {

struct FitCommand {
    FitJob job;
    std::string output, report;
    bool json = false, quiet = false;
};

void requireMaterialExtension(const std::string& path)
{
    const std::string extension = std::filesystem::path(path).extension().string();
    if (extension != ".fbrdf" && extension != ".txt" && extension != ".json")
        throw Error(ErrorKind::usage, path,
                    Found("extension '" + extension + "'").expected(".fbrdf, .txt or .json"));
}

double secondsToWrite(const Material& material, const std::string& path)
{
    const auto start = std::chrono::steady_clock::now();
    writeMaterial(material, path);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// All tables of a fit have one storage. The form svd has its own, whatever was asked for.
std::string storageText(const Material& material)
{
    return storageName(material.tables.front().storage);
}

Json samplesJson(const FitOutcome& outcome)
{
    const SampleReport& report = outcome.report;
    return {{"used", outcome.summary.used},
            {"invalid", invalidSamples(report)},
            {"below_floor", outcome.summary.belowFloor},
            {"given", report.given},
            {"non_finite", report.nonFinite},
            {"below_horizon", report.belowHorizon},
            {"marked_invalid", report.invalid},
            {"negative", report.negative},
            {"zero", report.zero},
            {"out_of_gamut", report.outOfGamut}};
}

// The errors of pictures and physics belong to no sample set, so both have them.
Json errorsJson(const FitOutcome& outcome)
{
    ErrorMap heldOut = outcome.heldOut, all = outcome.all;
    const ErrorMap scene = errorMap(outcome.scene);
    heldOut.insert(scene.begin(), scene.end());
    all.insert(scene.begin(), scene.end());
    return {{"held_out", jsonOf(heldOut)}, {"all", jsonOf(all)}};
}

Json trialsJson(const FitSummary& summary)
{
    Json trials = Json::array();
    for (const Trial& trial : summary.trials)
        trials.push_back({{"form", trial.form},
                          {"stage", trial.stage},
                          {"description", trial.description},
                          {"bytes", trial.bytes},
                          {"lookups", trial.lookups},
                          {"seconds", jsonOf(trial.seconds)},
                          {"score", jsonOf(trial.score)},
                          {"held_out", jsonOf(errorMap(trial.heldOut))},
                          {"chosen", trial.chosen}});
    return trials;
}

Json misfitsJson(const FitSummary& summary)
{
    Json regions = Json::array();
    for (const MisfitRegion& r : summary.misfits)
        regions.push_back({{"where", describe(r)},
                           {"theta_h", {r.theta_hFrom, r.theta_hTo}},
                           {"theta_d", {r.theta_dFrom, r.theta_dTo}},
                           {"channels", {r.channels[0], r.channels[1], r.channels[2]}},
                           {"samples", r.samples},
                           {"light", jsonOf(r.light)},
                           {"factor", jsonOf(r.factor)},
                           {"bias", jsonOf(r.bias)}});
    return {{"held", summary.misfits.empty()}, {"regions", regions}};
}

Json coverageJson(const FitSummary& summary)
{
    if (!summary.coverage) return {};
    const Coverage& c = *summary.coverage;
    return {{"in_plane_only", c.inPlane},
            {"one_azimuth", c.oneAzimuth},
            {"theta_i", {jsonOf(c.theta_iFrom), jsonOf(c.theta_iTo)}},
            {"incidences", c.incidences}};
}

Json solverJson(const SolverSummary& solver)
{
    return {{"termination", terminationName(solver.termination)},
            {"hit_limit", solver.hitLimit()},
            {"iterations", solver.iterations},
            {"system_iterations", solver.systemIterations},
            {"cost", jsonOf(solver.cost)}};
}

Json priorJson(const FitSummary& summary)
{
    if (!summary.prior) return {};
    const PriorSummary& prior = *summary.prior;
    return {{"tables", jsonOf(prior.tables)},
            {"samples", jsonOf(prior.samples)},
            {"distance", jsonOf(prior.distance)},
            {"unlike", prior.isUnlike()}};
}

Json tiltJson(const FitSummary& summary)
{
    if (!summary.tilt) return nullptr;
    constexpr double kDegrees = 180.0 / kPi;
    return {summary.tilt->x * kDegrees, summary.tilt->y * kDegrees};
}

Json summaryJson(const FitCommand& command, const FitOutcome& outcome, double writeSeconds)
{
    const Material& material = *outcome.material;
    return {{"source", sourceNote(command.job.source)},
            {"output", command.output},
            {"form", material.form.name},
            {"description", describe(material.form)},
            {"storage", storageText(material)},
            {"bytes", materialBytes(material)},
            {"seconds",
             {{"read", outcome.times.read},
              {"fit", outcome.times.fit},
              {"lobes", outcome.times.lobes},
              {"measure", outcome.times.measure},
              {"write", writeSeconds}}},
            {"samples", samplesJson(outcome)},
            {"assumptions", outcome.source.assumptions},
            {"errors", errorsJson(outcome)},
            {"smoothness", jsonOf(outcome.summary.smoothness)},
            {"prior", priorJson(outcome.summary)},
            {"solver", solverJson(outcome.summary.solver)},
            {"noise_floor", jsonOf(outcome.summary.noiseFloor)},
            {"conserve_scale", jsonOf(outcome.summary.conserved)},
            {"folds", outcome.summary.folds},
            {"misfit", misfitsJson(outcome.summary)},
            {"tilt_degrees", tiltJson(outcome.summary)},
            {"coverage", coverageJson(outcome.summary)},
            {"unsupported_texels", unsupportedTexels(material)},
            {"lobes", lobesJson(material.lobes)},
            {"reason", outcome.summary.reason},
            {"trials", trialsJson(outcome.summary)}};
}

std::string samplesText(const FitOutcome& outcome)
{
    std::string text = withSeparators(outcome.summary.used) + " used, " +
                       withSeparators(invalidSamples(outcome.report)) + " invalid, " +
                       withSeparators(outcome.summary.belowFloor) + " values below the noise floor";
    if (outcome.report.outOfGamut > 0)
        text += ", " + withSeparators(outcome.report.outOfGamut) + " out of gamut";
    return text;
}

std::string errorsText(const FitOutcome& outcome)
{
    const int folds = outcome.summary.folds;
    const std::string heldOut = folds > 0 ? fmt::format("held out ({})", folds) : "fresh set";
    return "  errors on samples\n" + errorTable({outcome.heldOut, outcome.all}, {heldOut, "all"}) +
           "  pictures and physics\n" + errorTable({errorMap(outcome.scene)}, {});
}

std::string supportText(const Material& material)
{
    const size_t unsupported = unsupportedTexels(material);
    if (unsupported == 0) return "every texel is supported by samples";
    size_t texels = 0;
    for (const Table& table : material.tables)
        texels += static_cast<size_t>(texelCount(table.domain));
    return withSeparators(unsupported) + " of " + withSeparators(texels) +
           " texels are supported by no sample";
}

std::string smoothnessText(const FitSummary& summary)
{
    return summary.smoothness > 0.0 ? fmt::format("{:.3g}", summary.smoothness) : "none";
}

std::string energyText(const FitCommand& command, const FitSummary& summary)
{
    if (!command.job.fit.conserve) return "as fitted (--conserve keeps albedos to 1)";
    return summary.conserved < 1.0
               ? fmt::format("scaled by {:.4f} so that no albedo exceeds 1", summary.conserved)
               : "no albedo exceeds 1";
}

std::string trialsText(const FitSummary& summary)
{
    if (summary.trials.empty()) return "";
    std::vector<std::vector<std::string>> rows{{"", "stage", "form", "bytes", "look-ups",
                                                "log_median", "cos_rms", "cuberoot_rms", "score",
                                                "tables"}};
    for (const Trial& t : summary.trials)
        rows.push_back(
            {t.chosen ? "*" : "", t.stage, t.form, withSeparators(t.bytes),
             fmt::format("{}", t.lookups), fmt::format("{:.4g}", t.heldOut.logMedian),
             fmt::format("{:.4g}", t.heldOut.cosRms), fmt::format("{:.4g}", t.heldOut.cubeRootRms),
             t.seconds > 0.0 ? fmt::format("{:.4g}", t.score) : "not tried", t.description});
    const Align l = Align::left, r = Align::right;
    return "  chosen: " + summary.reason + "\n  forms tried, errors held out; * chosen\n" +
           alignedTable({l, l, l, r, r, r, r, r, r, l}, rows, 4);
}

std::string misfitText(const FitSummary& summary)
{
    if (summary.misfits.empty()) return "";
    constexpr size_t kShown = 5;
    std::string text = "  the form does not fit the data:\n";
    for (size_t i = 0; i < std::min(kShown, summary.misfits.size()); ++i)
        text += "    " + describe(summary.misfits[i]) + "\n";
    if (summary.misfits.size() > kShown)
        text += fmt::format("    and {} regions more\n", summary.misfits.size() - kShown);
    return text;
}

std::string assumedText(const Source& source)
{
    if (source.assumptions.empty()) return "nothing: the source states all";
    return fmt::format("{}", fmt::join(source.assumptions, "; "));
}

std::string coverageText(const FitSummary& summary)
{
    return summary.coverage ? describe(*summary.coverage) : "a function: all directions";
}

std::string summaryText(const FitCommand& command, const FitOutcome& outcome, double writeSeconds)
{
    const Material& material = *outcome.material;
    const FitTimes& times = outcome.times;
    return material.name + " -> " + command.output + "\n" +
           alignedTable(
               {Align::left, Align::left},
               {{"form", material.form.name + ", " + withSeparators(materialBytes(material)) +
                             " bytes as " + storageText(material)},
                {"samples", samplesText(outcome)},
                {"assumed", assumedText(outcome.source)},
                {"tilt", outcome.summary.tilt
                             ? describe(*outcome.summary.tilt) + " (--as-mounted keeps it)"
                             : "none"},
                {"coverage", coverageText(outcome.summary)},
                {"support", supportText(material)},
                {"smoothness", smoothnessText(outcome.summary)},
                {"prior", priorText(outcome.summary)},
                {"solver", outcome.summary.solver.text()},
                {"energy", energyText(command, outcome.summary)},
                {"environments", lobesText(material.lobes)},
                {"seconds",
                 fmt::format("read {:.2f}, fit {:.2f}, lobes {:.2f}, measure {:.2f}, "
                             "write {:.2f}",
                             times.read, times.fit, times.lobes, times.measure, writeSeconds)}}) +
           misfitText(outcome.summary) + errorsText(outcome) + trialsText(outcome.summary);
}

// Under mpirun every rank adds up its share of the rows. All of them arrive at the same material,
// which rank 0 writes.
int run(FitCommand command)
{
    requireWritable(command.output);
    requireMaterialExtension(command.output);
    if (!command.report.empty()) requireWritable(command.report);
    const Ranks ranks;
    command.job.fit.ranks = {static_cast<size_t>(ranks.rank()), static_cast<size_t>(ranks.count()),
                             [&ranks](double* values, size_t count) { ranks.sum(values, count); }};
    Progress progress(!command.quiet && ranks.rank() == 0);
    const FitOutcome outcome = runFitJob(command.job, progress);
    if (ranks.rank() != 0) return 0;
    progress.phase("writing " + command.output);
    const double writeSeconds = secondsToWrite(*outcome.material, command.output);
    progress.phase("writing " + command.report);
    if (!command.report.empty()) writeFitReport(command.job, outcome, writeSeconds, command.report);
    progress.clear();
    if (command.json)
        writeOut(text(summaryJson(command, outcome, writeSeconds)));
    else if (!command.quiet)
        writeOut(summaryText(command, outcome, writeSeconds));
    return 0;
}

}  // namespace

void addFitCommand(CLI::App& app, Action& action)
{
    CLI::App* sub = app.add_subcommand("fit", "fit a material to reflectance");
    const auto command = std::make_shared<FitCommand>();
    sub->add_option("SOURCE", command->job.source, "file, or model NAME:key=value,...")->required();
    sub->add_option("-o,--output", command->output, "material to write (.fbrdf)")
        ->required()
        ->type_name("FILE");
    constexpr double kPatience = 10.0;  // seconds that a person waits for auto
    command->job.fit.seconds = kPatience;
    addFitOptions(*sub, command->job.fit);
    sub->add_option("--report", command->report, "self-contained HTML page about the fit")
        ->type_name("R.html");
    addLobes(*sub, command->job.lobes);
    addCosine(*sub, command->job.sourceOptions);
    sub->add_flag("--json", command->json, "print one JSON object");
    sub->add_flag("--quiet", command->quiet, "print nothing but errors");
    sub->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace fbrdf::tool

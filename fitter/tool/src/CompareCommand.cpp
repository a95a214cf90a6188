// fbrdf compare: the errors of one BRDF against another.
#include "Arguments.h"
#include "Commands.h"
#include "Errors.h"
#include "Output.h"
#include "Progress.h"
#include "Reflectance.h"
#include "SampleFacts.h"
#include "Scene.h"
#include "TextTable.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>
#include <fbrdf/codecs/PanoramaFile.h>
#include <fbrdf/environment/Sky.h>
#include <fbrdf/fit/NoiseFloor.h>
#include <fbrdf/metrics/EnvironmentSphere.h>
#include <fbrdf/metrics/SampleSets.h>
#include <fbrdf/sources/OpenSource.h>
#include <fmt/format.h>

#include <optional>

namespace fbrdf::tool {
namespace {

struct CompareCommand {
    std::string tested, reference;
    SourceOptions sourceOptions;
    std::string environment;   ///< a file, or the name of a built-in one; empty: not asked for
    int environmentSize = 64;  ///< pixels across the sphere
    bool json = false;
    int threads = 0;
};

struct ReferenceSet {
    bool own = false;        ///< the reference's samples, else the uniform set
    uint64_t available = 0;  ///< before thinning
    std::vector<Sample> samples;
    Vec3f floor{0.0f};
};

struct Comparison {
    ReferenceSet set;
    ErrorMap onSamples, ofScene;
    std::optional<double> environmentPsnr;
    std::string environmentNote;  ///< what its file was taken for
};

ReferenceSet referenceSet(const Reflectance& reference, int threads)
{
    ReferenceSet set;
    set.own = hasSamples(reference.source);
    if (set.own) {
        set.samples = thinnedSamples(reference.source, set.available);
        set.floor = estimateNoiseFloor(set.samples);
    } else {
        Source function;
        function.evaluate = reference.brdf;
        set.samples = samplesAt(function, uniformPairs(kUniformTestPairs), threads);
        set.available = set.samples.size();
    }
    return set;
}

Comparison compare(const Reflectance& tested, const Reflectance& reference, int threads,
                   Progress& progress)
{
    Comparison result;
    progress.phase("comparing samples");
    result.set = referenceSet(reference, threads);
    if (result.set.samples.empty())
        throw Error(ErrorKind::input, reference.source.name,
                    Found("no usable sample").expected("at least one"));
    const auto values = evaluateAt(tested.brdf, result.set.samples, threads);
    result.onSamples = errorMap(sampleErrors(result.set.samples, values, result.set.floor));
    progress.phase("comparing pictures");
    result.ofScene = errorMap(measureScene(tested.brdf, reference.brdf, threads));
    return result;
}

// The tested one is drawn as a renderer draws it, by its lobes; the reference is the sum over
// texels.
double environmentPsnr(const CompareCommand& command, const Reflectance& tested,
                       const Reflectance& reference, Progress& progress, std::string& note)
{
    const std::string& name = command.environment;
    progress.phase("lighting from " + name);
    const Panorama panorama =
        isProceduralEnvironment(name) ? proceduralEnvironment(name) : readPanorama(name, &note);
    const EnvironmentSphere sphere({panorama}, command.environmentSize,
                                   EnvironmentSphere::cubeSizeFor(command.environmentSize),
                                   command.threads);
    const auto lit = sphere.lit(lobesOf(tested, command.threads));
    return sphere.psnr(lit.front(), sphere.truth(reference.brdf).front(), 0);
}

Json environmentJson(const CompareCommand& command, const Comparison& result)
{
    if (!result.environmentPsnr) return nullptr;
    Json json = {{"name", command.environment}, {"psnr", jsonOf(*result.environmentPsnr)}};
    if (!result.environmentNote.empty()) json["note"] = result.environmentNote;
    return json;
}

std::string environmentText(const CompareCommand& command, const Comparison& result)
{
    if (!result.environmentPsnr) return "";
    return fmt::format(
        "  light from {}\n    psnr  {:.4g}  dB, of its lobes against the sum over texels\n{}",
        command.environment, *result.environmentPsnr,
        result.environmentNote.empty() ? "" : "    " + result.environmentNote + "\n");
}

Json comparisonJson(const CompareCommand& command, const Comparison& result)
{
    ErrorMap errors = result.onSamples;
    errors.insert(result.ofScene.begin(), result.ofScene.end());
    return {{"tested", command.tested},
            {"reference", command.reference},
            {"environment", environmentJson(command, result)},
            {"samples",
             {{"set", result.set.own ? "own" : "uniform"},
              {"used", result.set.samples.size()},
              {"available", result.set.available}}},
            {"noise_floor", jsonOf(result.set.floor)},
            {"errors", jsonOf(errors)}};
}

std::string setText(const ReferenceSet& set)
{
    std::string text = set.own ? withSeparators(set.samples.size()) + " samples of its own"
                               : withSeparators(set.samples.size()) + " of the uniform set";
    if (set.available > set.samples.size())
        text += " (thinned from " + withSeparators(set.available) + ")";
    if (set.own)
        text += fmt::format(", noise floor {:.3g} {:.3g} {:.3g}", set.floor.x, set.floor.y,
                            set.floor.z);
    return text;
}

std::string comparisonText(const CompareCommand& command, const Comparison& result)
{
    return alignedTable({Align::left, Align::left}, {{"tested", command.tested},
                                                     {"reference", command.reference},
                                                     {"samples", setText(result.set)}}) +
           "  errors on samples\n" + errorTable({result.onSamples}, {}) +
           "  pictures and physics\n" + errorTable({result.ofScene}, {}) +
           environmentText(command, result);
}

int run(const CompareCommand& command)
{
    Progress progress(true);
    progress.phase("reading");
    const Reflectance tested =
        openReflectance(command.tested, command.sourceOptions, Precision::shader);
    requireFunction(tested, command.tested);
    const Reflectance reference =
        openReflectance(command.reference, command.sourceOptions, Precision::shader);
    Comparison result = compare(tested, reference, command.threads, progress);
    if (!command.environment.empty()) {
        requireFunction(reference, command.reference);
        result.environmentPsnr =
            environmentPsnr(command, tested, reference, progress, result.environmentNote);
    }
    progress.clear();
    writeOut(command.json ? text(comparisonJson(command, result))
                          : comparisonText(command, result));
    return 0;
}

}  // namespace

void addCompareCommand(CLI::App& app, Action& action)
{
    CLI::App* sub = app.add_subcommand("compare", "errors of A against the reference B");
    const auto command = std::make_shared<CompareCommand>();
    sub->add_option("A", command->tested, "material, file with values everywhere, or model")
        ->required();
    sub->add_option("B", command->reference, "reference: material, file or model")->required();
    sub->add_option("--environment", command->environment,
                    "also under light from everywhere: a panorama, or " +
                        fmt::format("{}", fmt::join(proceduralEnvironments(), ", ")))
        ->type_name("FILE|NAME");
    addInteger(*sub, "--environment-size", command->environmentSize, 8, 512,
               "pixels across the sphere of --environment (64)")
        ->type_name("N");
    sub->add_flag("--json", command->json, "print one JSON object");
    addCosine(*sub, command->sourceOptions);
    addThreads(*sub, command->threads);
    sub->callback([command, &action] { action = [command] { return run(*command); }; });
}

}  // namespace fbrdf::tool

#include "FitJob.h"

#include "Reflectance.h"
#include "Version.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/fit/FormKey.h>
#include <fbrdf/sources/OpenSource.h>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>

namespace fbrdf::tool {
namespace {

class Stopwatch {
public:
    /// Seconds since it was made or last asked.
    double lap()
    {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - start_).count();
        start_ = now;
        return seconds;
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void addErrors(Material& material, const char* prefix, const ErrorMap& errors)
{
    for (const auto& [name, value] : errors) material.errors[prefix + name] = value;
}

void describe(Material& material, const FitJob& job, const FitOutcome& outcome)
{
    const FitSummary& summary = outcome.summary;
    const Vec3f& floor = summary.noiseFloor;
    material.name = outcome.source.name;
    auto& notes = material.notes;
    notes[kSourceNote] = sourceNote(job.source);
    notes["source format"] = outcome.source.format;
    notes["source description"] = outcome.source.description;
    notes[kOptionsNote] = optionsNote(job);
    notes[kGeneratorNote] = generatorNote();
    notes[kUsedNote] = fmt::format("{}", summary.used);
    notes[kInvalidNote] = fmt::format("{}", invalidSamples(outcome.report));
    notes[kBelowFloorNote] = fmt::format("{}", summary.belowFloor);
    notes[kFloorNote] = fmt::format("{} {} {}", floor.x, floor.y, floor.z);
    notes[kSmoothnessNote] = fmt::format("{}", summary.smoothness);
    if (summary.prior) notes["prior"] = priorText(summary);
    if (!summary.reason.empty()) notes["form chosen"] = summary.reason;
    if (!summary.misfits.empty()) notes[kMisfitNote] = describe(summary.misfits.front());
    if (!outcome.source.assumptions.empty())
        notes[kAssumedNote] = fmt::format("{}", fmt::join(outcome.source.assumptions, "; "));
    if (summary.tilt) notes["tilt"] = fbrdf::describe(*summary.tilt);
    if (summary.coverage) notes[kCoverageNote] = fbrdf::describe(*summary.coverage);
    addErrors(material, kHeldOutPrefix, outcome.heldOut);
    addErrors(material, kAllPrefix, outcome.all);
    addErrors(material, "", errorMap(outcome.scene));
}

LobeFitOptions lobesOf(const FitJob& job)
{
    LobeFitOptions options = lobeOptions(job.lobes.lobes);
    options.threads = job.fit.threads;
    return options;
}

}  // namespace

FitOutcome runFitJob(const FitJob& job, Progress& progress)
{
    FitOutcome outcome;
    Stopwatch watch;
    checkOptions(job.fit);  // before long reading
    progress.phase("reading " + sourceNote(job.source));
    outcome.source = openSource(job.source, job.sourceOptions);
    outcome.report = reportOf(outcome.source);
    outcome.times.read = watch.lap();
    progress.phase("fitting " + outcome.source.name);
    FitResult result = fitMaterial(outcome.source, job.fit);
    outcome.times.read += result.summary.readSeconds;
    outcome.times.fit = watch.lap() - result.summary.readSeconds;
    const auto material = std::make_shared<Material>(std::move(result.material));
    if (job.lobes.lobes > 0 && job.fit.ranks.rank == 0) {
        progress.phase("fitting lobes of " + outcome.source.name);
        material->lobes = fitLobes(*material, lobesOf(job));
    }
    outcome.times.lobes = watch.lap();
    progress.phase("measuring " + outcome.source.name);
    outcome.summary = std::move(result.summary);
    outcome.heldOut = errorMap(outcome.summary.heldOut);
    outcome.all = errorMap(outcome.summary.all);
    if (job.fit.ranks.rank == 0)  // the others only help to fit
        outcome.scene =
            measureScene(shaderFunction(material), outcome.source.evaluate, job.fit.threads);
    describe(*material, job, outcome);
    outcome.material = material;
    outcome.times.measure = watch.lap();
    return outcome;
}

size_t unsupportedTexels(const Material& material)
{
    size_t count = 0;
    for (const Table& table : material.tables) count += table.unsupportedCount();
    return count;
}

uint64_t invalidSamples(const SampleReport& report)
{
    return report.nonFinite + report.belowHorizon + report.invalid;
}

std::string priorText(const FitSummary& summary)
{
    if (!summary.prior) return "none";
    const PriorSummary& prior = *summary.prior;
    const std::string text = fmt::format(
        "known materials fill in what samples leave open; tables differ from them "
        "by {:.1f} %, samples by {:.1f} %; {} (distance {:.2g})",
        100.0 * prior.tables, 100.0 * prior.samples,
        prior.isUnlike() ? "unlike all that the prior knows" : "like them", prior.distance);
    if (summary.used >= kFewestCompared) return text;
    return text + fmt::format(
                      "; {} {}: most of what is seen is theirs, and no fit without them "
                      "was compared",
                      summary.used, summary.used == 1 ? "sample" : "samples");
}

// Colours in a model contain '/', so a path is only what exists. FILE@choice and FILE#choice count
// as paths too.
std::string sourceNote(const std::string& source)
{
    std::error_code ignored;
    const std::string file = source.substr(0, source.find_last_of("@#"));
    if (!std::filesystem::exists(source, ignored) && !std::filesystem::exists(file, ignored))
        return source;
    return std::filesystem::path(source).filename().string();
}

std::string optionsNote(const FitJob& job)
{
    const FitOptions& fit = job.fit;
    return fmt::format(
        "form={} resolution={} max-bytes={} lookups={} terms={} storage={} metric={} robust={} "
        "smoothness={} seed={} cosine={}{}{}{}{}{}{}",
        fit.formData ? formKey(*fit.formData) : fit.form, fit.resolution, fit.maxBytes, fit.lookups,
        fit.terms, storageName(fit.storage), metricName(fit.metric), fit.robust,
        fit.smoothness ? fmt::format("{}", *fit.smoothness) : "auto", fit.seed,
        job.sourceOptions.cosine, fit.sharedShape ? " shared" : "", fit.conserve ? " conserve" : "",
        fit.straightens ? "" : " as-mounted",
        isSearched(fit) ? fmt::format(" seconds={}", fit.seconds) : "",
        fit.usePrior ? (fit.prior ? " prior=file" : "") : " prior=none",
        job.lobes.lobes == LobeFitOptions{}.lobes
            ? ""
            : fmt::format(" environment-lobes={}", job.lobes.lobes));
}

std::string generatorNote()
{
    return std::string("fbrdf ") + kVersion;
}

}  // namespace fbrdf::tool

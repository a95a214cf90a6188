#include "FitReport.h"

#include <fbrdf/report/Report.h>
#include <fmt/format.h>

namespace fbrdf::tool {
namespace {

std::vector<ReportTrial> trialsOf(const FitSummary& summary)
{
    std::vector<ReportTrial> trials;
    for (const Trial& t : summary.trials)
        trials.push_back({t.form, t.description, t.bytes, t.lookups, t.seconds, errorMap(t.heldOut),
                          t.chosen, t.stage});
    return trials;
}

std::string heldOutNote(int folds)
{
    return folds > 0 ? fmt::format("{} of 5 folds of the samples", folds)
                     : "fresh pairs of directions";
}

}  // namespace

void writeFitReport(const FitJob& job, const FitOutcome& outcome, double writeSeconds,
                    const std::string& path)
{
    const FitSummary& summary = outcome.summary;
    ReportInput input{*outcome.material, outcome.source};
    input.lookups = lookupsPerLight(outcome.material->form);
    input.seconds = {outcome.times.read, outcome.times.fit, writeSeconds};
    input.counts = {summary.used, invalidSamples(outcome.report), summary.belowFloor};
    input.noiseFloor = summary.noiseFloor;
    input.heldOut = summary.heldOut;
    input.all = summary.all;
    input.heldOutNote = heldOutNote(summary.folds);
    input.physics = outcome.scene.physics;
    input.sphereOfFit = outcome.scene.picture;
    input.sphereOfData = outcome.scene.reference;
    input.image = outcome.scene.image;
    input.misfits = summary.misfits;
    input.coverage = summary.coverage;
    input.trials = trialsOf(summary);
    input.command = "fbrdf fit " + sourceNote(job.source) + " (" + optionsNote(job) + ")";
    writeReport(input, path);
}

}  // namespace fbrdf::tool

#include "search/TrialRuns.h"

#include "search/Search.h"

#include <fbrdf/base/Assert.h>

#include <cmath>

namespace fbrdf {
namespace {

constexpr size_t kAutoBytes = 32768;  // without --max-bytes
constexpr size_t kMaxTrials = 32;

}  // namespace

size_t TrialRuns::budget() const
{
    return all_.options.maxBytes > 0 ? all_.options.maxBytes : kAutoBytes;
}

bool TrialRuns::isFull() const
{
    return rows_.size() >= kMaxTrials;
}

Candidate TrialRuns::added(const Form& form, const std::string& stage)
{
    Trial trial;
    trial.form = form.name;
    trial.stage = stage;
    trial.description = describe(form);
    trial.bytes = bytesOf(all_, form);
    trial.lookups = lookupsPerLight(form);
    rows_.push_back(trial);
    return {form, rows_.size() - 1, trial.bytes, {}, {}};
}

void TrialRuns::record(Candidate& candidate, double seconds)
{
    constexpr double kZero = 1e-12;  // a fit without any error has a logarithm too
    const SampleErrors& errors = candidate.held.errors;
    Trial& trial = rows_[candidate.trial];
    trial.seconds += seconds;
    trial.heldOut = errors;
    trial.score = scoreOf(errors, all_.options.metric);
    candidate.marks.push_back({trial.score, 0.5 * (std::log(trial.score + kZero) +
                                                   std::log(errors.cubeRootRms + kZero))});
}

Candidate TrialRuns::start(const Form& form, const std::string& stage, double smoothness)
{
    Candidate candidate = added(form, stage);
    candidate.held.smoothness = all_.options.smoothness.value_or(smoothness);
    goOn(candidate, 1);
    return candidate;
}

void TrialRuns::goOn(Candidate& candidate, int folds)
{
    FBRDF_ASSERT(folds, <=, part_.folds);
    const Clock clock;
    holdOut(part_, candidate.form, candidate.held.smoothness, folds, candidate.held);
    record(candidate, clock.seconds());
}

std::optional<Candidate> TrialRuns::attempt(const Form& variant, const std::string& stage,
                                            const Candidate& reference, double change)
{
    Candidate next = start(variant, stage, reference.held.smoothness);
    for (int folds = 1;; ++folds) {
        const Marks &ours = next.marks.back(),
                    &theirs = reference.marks[static_cast<size_t>(folds - 1)];
        const double slack = folds < part_.folds ? slackOf(next.held) : 0.0;
        if (ours.merit > theirs.merit + change + slack ||
            ours.score > theirs.score * kAllowed * (1.0 + slack))
            return std::nullopt;
        if (folds == part_.folds) return next;
        goOn(next, folds + 1);
    }
}

Candidate TrialRuns::finish(const Source& source, const Form& form, Fitted& fitted)
{
    const Clock clock;
    Candidate candidate = added(form, "final");
    fitted = fitForm(all_, form);
    candidate.held.errors = heldOutErrors(source, all_, fitted);
    record(candidate, clock.seconds());
    return candidate;
}

}  // namespace fbrdf

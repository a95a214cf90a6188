#include "search/Search.h"

#include "data/Symmetry.h"
#include "search/NamedTrials.h"
#include "search/Neighbours.h"

#include <fbrdf/base/Error.h>

namespace fbrdf {
namespace {

constexpr size_t kTrialSamples = 32768;  // enough to rank forms

Job trialJob(const Job& job)
{
    std::vector<Sample> some;
    if (job.feed.rows > kTrialSamples)
        some = someSamples(job.feed, FoldChoice::all(), kTrialSamples, job.options.seed,
                           job.options.threads);
    return partOf(job, std::move(some));
}

// Among few or noisy samples a search of sizes and warps finds what suits the noise.
bool goesOn(const Job& job)
{
    const bool isClean = job.traits.floor == Vec3f(0.0f) && job.feed.rows > kTrialSamples;
    return job.options.form == kBestOf || isClean;
}

// The forms of rows that no time was spent on.
std::string untried(const std::vector<Trial>& trials)
{
    std::string names;
    for (const Trial& trial : trials)
        if (trial.seconds == 0.0) names += (names.empty() ? "" : ", ") + trial.form;
    return names.empty() ? "" : "; not tried for want of time: " + names;
}

[[noreturn]] void refuseBudget(const FitOptions& options, size_t budget)
{
    throw Error(ErrorKind::usage, options.maxBytes > 0 ? "max-bytes" : "resolution",
                "found no form of at most " + std::to_string(budget) + " bytes and " +
                    std::to_string(options.lookups) + " look-ups a pass, expected room for one");
}

}  // namespace

Fitted searchForm(const Source& source, const Job& job, std::vector<Trial>& trials,
                  std::string& reason)
{
    const Job part = trialJob(job);
    TrialRuns runs(job, part, isIsotropicSource(source), trials);
    std::vector<Candidate> named = tryNamed(runs, candidateNames(source, job.options.terms));
    if (named.empty()) refuseBudget(job.options, runs.budget());
    const Choice choice = choose(named);
    reason = choice.reason + untried(trials);
    Candidate best = std::move(named[choice.index]);
    if (goesOn(job)) improve(runs, best);
    runs.choose(best);
    if (!best.whole) return fitForm(job, best.form);
    if (!job.feed.exact) best.whole->heldOut = best.held.errors;
    return std::move(*best.whole);
}

}  // namespace fbrdf

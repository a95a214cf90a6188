#include "search/Search.h"

#include "data/Symmetry.h"
#include "search/Finals.h"
#include "search/NamedTrials.h"
#include "search/Neighbours.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/base/Found.h>

namespace fbrdf {
namespace {

constexpr size_t kTrialSamples = 32768;  // enough to rank forms

// An isotropic source's samples hold good turned about the normal. Maps over directions that had a
// sample or two a texel, at one azimuth of the light, are seen through.
FitContext trialContext(const FitContext& context, bool isIsotropic)
{
    std::vector<Sample> some;
    if (context.dataset.rows > kTrialSamples)
        some = someSamples(context.dataset, FoldChoice::all(), kTrialSamples, context.options.seed,
                           context.options.threads);
    FitContext part = partOf(context, std::move(some));
    part.turnsHeldOut = isIsotropic;
    return part;
}

// Among few or noisy samples a search of sizes and warps finds what suits the noise.
bool goesOn(const FitContext& context)
{
    const bool isClean =
        context.statistics.floor == Vec3f(0.0f) && context.dataset.rows > kTrialSamples;
    return context.options.form == kBestOf || isClean;
}

std::vector<std::string> namesFor(const Source& source, const FitOptions& options)
{
    if (!isSearched(options)) return {options.form};
    return candidateNames(source, options.terms);
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
                Found("no form of at most " + std::to_string(budget) + " bytes and " +
                      std::to_string(options.lookups) + " look-ups a pass")
                    .expected("room for one"));
}

}  // namespace

Fitted searchForm(const Source& source, const FitContext& context, std::vector<Trial>& trials,
                  std::string& reason)
{
    const bool isotropic = isIsotropicSource(source);
    const FitContext part = trialContext(context, isotropic);
    TrialRuns runs(context, part, isotropic, trials);
    std::vector<Candidate> named = tryNamed(runs, namesFor(source, context.options));
    if (named.empty()) refuseBudget(context.options, runs.budget());
    Choice choice = choose(named);
    Candidate best = named[choice.index];
    if (goesOn(context)) improve(runs, best);
    if (runs.hasPlenty() && isSearched(context.options)) {
        std::vector<Candidate> finals =
            tryFinals(runs, source.evaluate, std::move(best), std::move(named));
        const Choice last = choose(finals);
        if (finals.size() > 1) choice.reason = last.reason;
        best = std::move(finals[last.index]);
    }
    reason = choice.reason + untried(trials);
    runs.choose(best);
    if (!best.whole) return fitForm(context, best.form, &best.held.solution);
    const bool isStated = runs.isWhole() && (isIsotropic(best.form) || !part.turnsHeldOut);
    if (!context.dataset.exact && isStated) best.whole->fitted.heldOut = best.held.errors;
    return std::move(best.whole->fitted);
}

}  // namespace fbrdf

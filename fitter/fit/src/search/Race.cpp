#include "search/Race.h"

#include "forms/NamedForms.h"

#include <algorithm>

namespace fbrdf {
namespace {

// The form at its size, or nothing where it is not within the options.
std::optional<Form> sized(const TrialRuns& runs, const std::string& name)
{
    const FitOptions& options = runs.all().options;
    if (lookupsPerPass(makeForm(name)) > options.lookups) return std::nullopt;
    if (options.resolution > 0) {
        const Form form = makeForm(name, options.resolution);
        return runs.isWithin(form) ? std::optional(form) : std::nullopt;
    }
    return largestFormFor(name, decidingSamples(runs.all()),
                          runs.budget() * (options.sharedShape ? 3 : 1), options.storage);
}

void leaveBehind(std::vector<Candidate>& candidates)
{
    const double most = leastScore(candidates) * (1.0 + slackOf(candidates.front().held));
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [most](const Candidate& c) { return c.score() > most; }),
                     candidates.end());
}

}  // namespace

std::vector<Candidate> race(TrialRuns& runs, const std::vector<std::string>& names)
{
    std::vector<Candidate> candidates;
    for (const std::string& name : names)
        if (const auto form = sized(runs, name))
            candidates.push_back(runs.start(*form, "form", 0.0));
    for (int folds = 2; !candidates.empty() && folds <= runs.part().folds; ++folds) {
        leaveBehind(candidates);
        for (Candidate& c : candidates) runs.goOn(c, folds);
    }
    return candidates;
}

}  // namespace fbrdf

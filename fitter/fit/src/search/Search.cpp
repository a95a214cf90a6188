#include "search/Search.h"

#include "data/Symmetry.h"
#include "search/Neighbours.h"
#include "search/Race.h"

#include <fbrdf/base/Error.h>

#include <algorithm>

namespace fbrdf {
namespace {

constexpr size_t kTrialSamples = 32768;  // enough to rank forms
constexpr size_t kFinalists = 3;
// A named form whose score is this near the best is fitted once more to all data: on a part of the
// samples the difference is noise, and the choice of the smoothness may change it.
constexpr double kNear = 1.15, kNearOfAll = 1.05;

std::vector<std::string> candidateNames(const Source& source, int terms)
{
    std::vector<std::string> names;
    const auto add = [&](int count, std::initializer_list<const char*> forms) {
        if (count <= terms) names.insert(names.end(), forms.begin(), forms.end());
    };
    if (isIsotropicSource(source)) {
        add(1, {"hdio", "hdg", "hdpio"});
        add(2, {"gg+hdg", "gg+hdpio", "io+hdio"});
        add(3, {"gg+hdg+hdio"});
        // Scattered samples show that they are isotropic only where they are near each other.
        if (!source.evaluate) add(2, {"io+pqpr"});
        if (isReciprocalSource(source)) return names;
        add(1, {"hdpu"});
        if (source.evaluate)
            add(2, {"u+hdpu"});  // a function that is known not to be reciprocal gains from it
    } else {
        add(1, {"hdio", "pqp", "pqpr", "qdio", "qdg", "pqtr", "pqpd", "pqpn"});
        add(2, {"gg+pqpr", "gg+qdio", "gg+qdg", "io+pqpr", "io+hdio"});
        add(3, {"gg+hdio+pqpr"});
    }
    return names;
}

// The best form, and the named forms whose trials were as good as the best named one.
std::vector<Candidate> finalists(const TrialRuns& runs, const Candidate& best,
                                 std::vector<Candidate> named)
{
    const bool isPart = runs.part().feed.rows < runs.all().feed.rows;
    const double near = leastScore(named) * (isPart ? kNear : kNearOfAll);
    std::sort(named.begin(), named.end(), byScore);
    std::vector<Candidate> result{best};
    for (const Candidate& c : named)
        if (result.size() < kFinalists && c.trial != best.trial && c.score() <= near)
            result.push_back(c);
    return result;
}

// Fits the finalists to all data, and returns the fit that does best.
Fitted fitFinalists(TrialRuns& runs, const Source& source, const std::vector<Candidate>& candidates)
{
    std::vector<Candidate> finals;
    std::vector<Fitted> fits(candidates.size());
    for (size_t i = 0; i < candidates.size(); ++i)
        finals.push_back(runs.finish(source, candidates[i].form, fits[i]));
    const Candidate& chosen = pick(finals);
    runs.choose(chosen);
    return std::move(fits[static_cast<size_t>(&chosen - finals.data())]);
}

Job trialJob(const Job& job)
{
    std::vector<Sample> some;
    if (job.feed.rows > kTrialSamples)
        some = someSamples(job.feed, FoldChoice::all(), kTrialSamples, job.options.seed,
                           job.options.threads);
    return partOf(job, std::move(some));
}

[[noreturn]] void refuseBudget(const FitOptions& options, size_t budget)
{
    throw Error(ErrorKind::usage, options.maxBytes > 0 ? "max-bytes" : "resolution",
                "found no form of at most " + std::to_string(budget) + " bytes and " +
                    std::to_string(options.lookups) + " look-ups a pass, expected room for one");
}

}  // namespace

double scoreOf(const SampleErrors& errors, Metric metric)
{
    switch (metric) {
        case Metric::cubeRoot: return errors.cubeRootRms;
        case Metric::log1p: return errors.nbrdfLoss;
        default: return errors.logMedian;
    }
}

Fitted searchForm(const Source& source, const Job& job, std::vector<Trial>& trials)
{
    const Job part = trialJob(job);
    TrialRuns runs(job, part, trials);
    const auto named = race(runs, candidateNames(source, job.options.terms));
    if (named.empty()) refuseBudget(job.options, runs.budget());
    Candidate best = pick(named);
    improve(runs, best);
    return fitFinalists(runs, source, finalists(runs, best, named));
}

}  // namespace fbrdf

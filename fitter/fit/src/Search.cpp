#include "Search.h"

#include "FormVariants.h"
#include "Isotropy.h"
#include "NamedForms.h"

#include <fbrdf/brdf/Error.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr size_t kTrialSamples = 32768;  // enough to tell forms apart
constexpr size_t kAutoBytes = 32768;     // without --max-bytes
constexpr size_t kMaxTrials = 32;        // before the finals; bounds the time
constexpr size_t kFinalists = 3;
constexpr double kNear = 1.15;  // of the best score: what a part of the samples cannot tell apart
// The result's score is at most this much of the least of all trials: what saving bytes may cost.
constexpr double kAllowed = 1.01;
// Least fall of the errors that pays for another warp, and for texels: half as many again.
constexpr double kWorthWarp = 0.01, kWorthTexels = 0.05;
// Errors below which nothing is left to see: no more texels, no other warps.
constexpr double kFineScore = 2e-3, kFineCubeRoot = 5e-3;
constexpr double kSizeStep = 1.5, kWarpStep = 1.4;

struct Candidate {
    Form form;
    size_t trial = 0;  ///< its row
    size_t bytes = 0;
    double score = 0;
    /// Mean logarithm of the score and of the error in the cube-root metric: the first says how
    /// well most directions are held, the second sees highlights.
    double merit = 0;
    double smoothness = 0;
    bool fine = false;
};

class Search {
public:
    Search(const Job& all, const Job& part, std::vector<Trial>& trials)
        : all_(all), part_(part), trials_(trials)
    {
    }

    size_t budget() const { return all_.options.maxBytes > 0 ? all_.options.maxBytes : kAutoBytes; }

    std::vector<Candidate> tryForms(const std::vector<std::string>& names)
    {
        std::vector<Candidate> candidates;
        for (const std::string& name : names)
            if (const auto form = sized(name)) candidates.push_back(attempt(*form, "form", 0.0));
        return candidates;
    }

    void improve(Candidate& best)
    {
        if (all_.options.resolution == 0) grow(best);
        warp(best);
        if (all_.options.resolution == 0) shrink(best);
    }

    /// The best of some candidates: of those near the least score the smallest, then the best.
    Candidate pick(const std::vector<Candidate>& candidates) const
    {
        const auto byScore = [](const Candidate& a, const Candidate& b) {
            return a.score < b.score;
        };
        const double least = std::min_element(candidates.begin(), candidates.end(), byScore)->score;
        const Candidate* best = nullptr;
        for (const Candidate& c : candidates) {
            if (c.score > least * kAllowed) continue;
            if (!best || c.bytes < best->bytes || (c.bytes == best->bytes && c.score < best->score))
                best = &c;
        }
        return *best;
    }

    /// All data, and the errors that will be stated.
    Candidate final(const Source& source, const Form& form, Fitted& fitted)
    {
        const Clock clock;
        fitted = fitForm(all_, form);
        return record(form, "final", {heldOutErrors(source, all_, fitted), fitted.smoothness},
                      clock);
    }

private:
    std::optional<Form> sized(const std::string& name) const
    {
        if (lookupsPerPass(makeForm(name)) > all_.options.lookups) return std::nullopt;
        if (all_.options.resolution > 0) {
            const Form form = makeForm(name, all_.options.resolution);
            return isWithin(form) ? std::optional(form) : std::nullopt;
        }
        return largestFormFor(name, decidingSamples(all_),
                              budget() * (all_.options.sharedShape ? 3 : 1), all_.options.storage);
    }

    bool isWithin(const Form& form) const { return bytesOf(all_, form) <= budget(); }

    Candidate attempt(const Form& form, const std::string& stage, double smoothness)
    {
        const Clock clock;
        return record(
            form, stage,
            heldOutOf(part_, form, all_.options.smoothness.value_or(smoothness), part_.folds),
            clock);
    }

    Candidate record(const Form& form, const std::string& stage, const HeldOut& held,
                     const Clock& clock)
    {
        Trial trial;
        trial.form = form.name;
        trial.stage = stage;
        trial.description = describe(form);
        trial.bytes = bytesOf(all_, form);
        trial.lookups = lookupsPerLight(form);
        trial.seconds = clock.seconds();
        trial.heldOut = held.errors;
        trial.score = scoreOf(held.errors, all_.options.metric);
        trials_.push_back(trial);
        constexpr double kZero = 1e-12;  // a fit without any error has a logarithm too
        return {form,
                trials_.size() - 1,
                trial.bytes,
                trial.score,
                0.5 * (std::log(trial.score + kZero) + std::log(held.errors.cubeRootRms + kZero)),
                held.smoothness,
                trial.score < kFineScore && held.errors.cubeRootRms < kFineCubeRoot};
    }

    /// Takes the variant when it lowers the errors by `worth`, without giving up the score.
    bool take(Candidate& best, const std::optional<Form>& variant, const char* stage, double worth)
    {
        if (!variant || best.fine || !isWithin(*variant) || trials_.size() >= kMaxTrials)
            return false;
        const Candidate next = attempt(*variant, stage, best.smoothness);
        if (next.merit > best.merit + std::log(1.0 - worth) || next.score > best.score * kAllowed)
            return false;
        best = next;
        return true;
    }

    // Of uniform arrays neither texels nor warps are worth a trial: they are fine, and free.
    std::vector<size_t> maps(const Form& form) const
    {
        std::vector<size_t> indices;
        for (size_t t = 0; t < form.tables.size(); ++t)
            if (!form.tables[t].uniform) indices.push_back(t);
        return indices;
    }

    // Where the budget is used up, the other maps make room.
    std::optional<Form> grown(const Form& form, size_t table) const
    {
        auto result = resized(form, table, kSizeStep);
        for (const size_t other : maps(form))
            if (result && !isWithin(*result) && other != table)
                if (const auto traded = resized(*result, other, 1.0 / kSizeStep)) result = traded;
        return result;
    }

    bool decides(const std::optional<Form>& form) const
    {
        return form && formTexels(*form) * kSamplesPerTexel <= decidingSamples(all_);
    }

    void grow(Candidate& best)
    {
        for (const size_t table : maps(best.form))
            for (auto next = grown(best.form, table);
                 decides(next) && take(best, next, "size", kWorthTexels);
                 next = grown(best.form, table)) {
            }
    }

    void warp(Candidate& best)
    {
        for (const size_t table : maps(best.form))
            for (size_t axis = 0; axis < warpCount(best.form.tables[table].domain); ++axis)
                for (const double step : {kWarpStep, 1.0 / kWarpStep})
                    while (take(best, rewarped(best.form, table, axis, step), "warp", kWorthWarp)) {
                    }
    }

    // Texels that change nothing are given back; what that costs must not add up.
    void shrink(Candidate& best)
    {
        const double most = best.score * kAllowed, worst = best.merit + std::log(kAllowed);
        for (const size_t table : maps(best.form))
            while (const auto smaller = resized(best.form, table, 1.0 / kSizeStep)) {
                if (trials_.size() >= kMaxTrials) return;
                const Candidate next = attempt(*smaller, "size", best.smoothness);
                if (next.score > most || next.merit > worst) break;
                best = next;
            }
    }

    const Job &all_, &part_;
    std::vector<Trial>& trials_;
};

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
    } else {
        add(1, {"hdio", "pqp", "pqpr", "qdio", "qdg", "pqtr", "pqpd", "pqpn"});
        add(2, {"gg+pqpr", "gg+qdio", "gg+qdg", "io+pqpr", "io+hdio"});
        add(3, {"gg+hdio+pqpr"});
    }
    return names;
}

std::vector<Candidate> finalists(const Candidate& best, std::vector<Candidate> named)
{
    std::sort(named.begin(), named.end(),
              [](const Candidate& a, const Candidate& b) { return a.score < b.score; });
    std::vector<Candidate> result{best};
    for (const Candidate& c : named)
        if (result.size() < kFinalists && c.trial != best.trial &&
            c.score <= kNear * named.front().score)
            result.push_back(c);
    return result;
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
    std::vector<Sample> some;
    if (job.feed.rows > kTrialSamples)
        some = someSamples(job.feed, FoldChoice::all(), kTrialSamples, job.options.seed,
                           job.options.threads);
    const Job part = partOf(job, std::move(some));
    Search search(job, part, trials);
    const auto named = search.tryForms(candidateNames(source, job.options.terms));
    if (named.empty())
        throw Error(ErrorKind::usage, job.options.maxBytes > 0 ? "max-bytes" : "resolution",
                    "found no form of at most " + std::to_string(search.budget()) + " bytes and " +
                        std::to_string(job.options.lookups) +
                        " look-ups a pass, expected room for one");
    Candidate best = search.pick(named);
    search.improve(best);
    std::vector<Candidate> finals;
    std::vector<Fitted> fits;
    for (const Candidate& c : finalists(best, named))
        finals.push_back(search.final(source, c.form, fits.emplace_back()));
    const size_t chosen = search.pick(finals).trial;
    trials[chosen].chosen = true;
    return std::move(fits[chosen - finals.front().trial]);
}

}  // namespace fbrdf

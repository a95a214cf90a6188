#include "Search.h"

#include "data/Symmetry.h"
#include "forms/FormVariants.h"
#include "forms/NamedForms.h"

#include <fbrdf/base/Error.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr size_t kTrialSamples = 32768;  // enough to tell forms apart
constexpr size_t kAutoBytes = 32768;     // without --max-bytes
constexpr size_t kMaxTrials = 32;        // before the finals; bounds the time
constexpr size_t kFinalists = 3;
// Of the best score: what a part of the samples cannot tell apart, and what the choice of the
// smoothness may change.
constexpr double kNear = 1.15, kNearOfAll = 1.05;
// The result's score is at most this much of the least of all trials: what saving bytes may cost.
constexpr double kAllowed = 1.01;
// Least fall of the errors that pays for another warp, and for texels: half as many again.
constexpr double kWorthWarp = 0.01, kWorthTexels = 0.05;
// Errors below which nothing is left to see: no more texels, no other warps.
constexpr double kFineScore = 2e-3, kFineCubeRoot = 5e-3;
constexpr double kSizeStep = 1.5, kWarpStep = 1.4;

/// How a candidate stands.
struct Marks {
    double score = 0;
    /// Mean logarithm of the score and of the error in the cube-root metric: the first says how
    /// well most directions are held, the second sees highlights.
    double merit = 0;
};

struct Candidate {
    Form form;
    size_t trial = 0;  ///< its row
    size_t bytes = 0;
    HeldOut held;
    std::vector<Marks> marks;  ///< after each fold

    double score() const { return marks.back().score; }
    bool isFine() const { return score() < kFineScore && held.errors.cubeRootRms < kFineCubeRoot; }
};

// What the samples left out so far cannot tell apart, relative. The median of n normal errors is
// known to 1.17 / sqrt(n); two candidates err on the same samples, and much alike.
double slackOf(const HeldOut& held)
{
    constexpr double kSure = 4.0;
    return kSure / std::sqrt(static_cast<double>(std::max<size_t>(1, held.samples.size())));
}

class Search {
public:
    Search(const Job& all, const Job& part, std::vector<Trial>& trials)
        : all_(all), part_(part), trials_(trials)
    {
    }

    size_t budget() const { return all_.options.maxBytes > 0 ? all_.options.maxBytes : kAutoBytes; }

    /// Candidates race: who has fallen behind for certain is left out of the folds to come (Maron
    /// and Moore 1994, "Hoeffding races").
    std::vector<Candidate> tryForms(const std::vector<std::string>& names)
    {
        std::vector<Candidate> candidates;
        for (const std::string& name : names)
            if (const auto form = sized(name)) candidates.push_back(start(*form, "form", 0.0));
        for (int folds = 2; folds <= part_.folds; ++folds) {
            leaveBehind(candidates);
            for (Candidate& c : candidates) goOn(c, folds);
        }
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
        const double least = leastScore(candidates);
        const Candidate* best = nullptr;
        for (const Candidate& c : candidates) {
            if (c.score() > least * kAllowed) continue;
            if (!best || c.bytes < best->bytes ||
                (c.bytes == best->bytes && c.score() < best->score()))
                best = &c;
        }
        return *best;
    }

    /// All data, and the errors that will be stated.
    Candidate final(const Source& source, const Form& form, Fitted& fitted)
    {
        const Clock clock;
        Candidate candidate = added(form, "final");
        fitted = fitForm(all_, form);
        candidate.held.errors = heldOutErrors(source, all_, fitted);
        record(candidate, clock.seconds());
        return candidate;
    }
    /// The best, and the named that the trials do not tell from the best of them.
    std::vector<Candidate> finalists(const Candidate& best, std::vector<Candidate> named) const
    {
        const double near =
            leastScore(named) * (part_.feed.rows < all_.feed.rows ? kNear : kNearOfAll);
        std::sort(named.begin(), named.end(), byScore);
        std::vector<Candidate> result{best};
        for (const Candidate& c : named)
            if (result.size() < kFinalists && c.trial != best.trial && c.score() <= near)
                result.push_back(c);
        return result;
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

    static bool byScore(const Candidate& a, const Candidate& b) { return a.score() < b.score(); }
    static double leastScore(const std::vector<Candidate>& candidates)
    {
        return std::min_element(candidates.begin(), candidates.end(), byScore)->score();
    }

    Candidate added(const Form& form, const std::string& stage)
    {
        Trial trial;
        trial.form = form.name;
        trial.stage = stage;
        trial.description = describe(form);
        trial.bytes = bytesOf(all_, form);
        trial.lookups = lookupsPerLight(form);
        trials_.push_back(trial);
        return {form, trials_.size() - 1, trial.bytes, {}, {}};
    }

    void record(Candidate& candidate, double seconds)
    {
        constexpr double kZero = 1e-12;  // a fit without any error has a logarithm too
        const SampleErrors& errors = candidate.held.errors;
        Trial& trial = trials_[candidate.trial];
        trial.seconds += seconds;
        trial.heldOut = errors;
        trial.score = scoreOf(errors, all_.options.metric);
        candidate.marks.push_back({trial.score, 0.5 * (std::log(trial.score + kZero) +
                                                       std::log(errors.cubeRootRms + kZero))});
    }

    /// The first fold. `smoothness` 0: the fold chooses it, for those to come as well.
    Candidate start(const Form& form, const std::string& stage, double smoothness)
    {
        Candidate candidate = added(form, stage);
        candidate.held.smoothness = all_.options.smoothness.value_or(smoothness);
        goOn(candidate, 1);
        return candidate;
    }

    void goOn(Candidate& candidate, int folds)
    {
        const Clock clock;
        holdOut(part_, candidate.form, candidate.held.smoothness, folds, candidate.held);
        record(candidate, clock.seconds());
    }

    static void leaveBehind(std::vector<Candidate>& candidates)
    {
        const double most = leastScore(candidates) * (1.0 + slackOf(candidates.front().held));
        candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                        [most](const Candidate& c) { return c.score() > most; }),
                         candidates.end());
    }

    /// The variant, unless a fold shows that its merit changes by more than `change` against
    /// `reference`, or that it gives up the score.
    std::optional<Candidate> attempt(const Form& variant, const std::string& stage,
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

    /// Takes the variant when it lowers the errors by `worth`, without giving up the score.
    bool take(Candidate& best, const std::optional<Form>& variant, const char* stage, double worth)
    {
        if (!variant || best.isFine() || !isWithin(*variant) || trials_.size() >= kMaxTrials)
            return false;
        auto next = attempt(*variant, stage, best, std::log(1.0 - worth));
        if (!next) return false;
        best = std::move(*next);
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
        const Candidate reference = best;
        for (const size_t table : maps(best.form))
            while (const auto smaller = resized(best.form, table, 1.0 / kSizeStep)) {
                if (trials_.size() >= kMaxTrials) return;
                auto next = attempt(*smaller, "size", reference, std::log(kAllowed));
                if (!next) break;
                best = std::move(*next);
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
        // Scattered samples look isotropic as far as they are near each other, and no further.
        if (!source.evaluate) add(2, {"io+pqpr"});
        if (isReciprocalSource(source)) return names;
        add(1, {"hdpu"});
        if (source.evaluate) add(2, {"u+hdpu"});  // known to gain from it
    } else {
        add(1, {"hdio", "pqp", "pqpr", "qdio", "qdg", "pqtr", "pqpd", "pqpn"});
        add(2, {"gg+pqpr", "gg+qdio", "gg+qdg", "io+pqpr", "io+hdio"});
        add(3, {"gg+hdio+pqpr"});
    }
    return names;
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
    for (const Candidate& c : search.finalists(best, named))
        finals.push_back(search.final(source, c.form, fits.emplace_back()));
    const size_t chosen = search.pick(finals).trial;
    trials[chosen].chosen = true;
    return std::move(fits[chosen - finals.front().trial]);
}

}  // namespace fbrdf

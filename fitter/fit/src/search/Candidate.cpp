#include "search/Candidate.h"

#include "search/SeenErrors.h"

#include <fbrdf/base/Assert.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace fbrdf {
namespace {

double meanOf(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) /
           static_cast<double>(std::max<size_t>(1, values.size()));
}

auto costOf(const Candidate& c)
{
    return std::make_tuple(c.lookups, c.form.terms.size(), c.bytes);
}

// Samples so many that trials are fitted to a part of them are held out by the thousand, and their
// errors are as good as those on all.
const SampleErrors& errorsOnAll(const Candidate& c)
{
    return c.whole ? c.whole->all : c.held.errors;
}

// Candidates whose marks are above that of `best` by chance, if at all. More terms than its own
// would only follow the samples better, and not what is between them.
std::vector<const Candidate*> equalsOf(const Candidate& best,
                                       const std::vector<const Candidate*>& candidates)
{
    std::vector<const Candidate*> equals;
    for (const Candidate* c : candidates)
        if (c->form.terms.size() <= best.form.terms.size() &&
            c->mark() - best.mark() <= leadOf(best, *c).error)
            equals.push_back(c);
    return equals;
}

// The cheapest of those that no other is better than on all samples, or `best` where there is none.
const Candidate* cheapestUnbeaten(const Candidate& best,
                                  const std::vector<const Candidate*>& equals)
{
    const Candidate* cheapest = nullptr;
    for (const Candidate* c : equals) {
        const bool isBeaten =
            std::any_of(equals.begin(), equals.end(),
                        [c](const Candidate* other) { return isBetterOnAll(*other, *c); });
        if (!isBeaten && (!cheapest || costOf(*c) < costOf(*cheapest))) cheapest = c;
    }
    return cheapest ? cheapest : &best;
}

std::string percent(double difference)
{
    return fmt::format("{:.1f} %", 100.0 * std::abs(std::expm1(difference)));
}

// A form may stand beside itself at another size, or with other warps.
std::string nameBeside(const Candidate& c, const Candidate& other)
{
    if (c.form.name != other.form.name) return c.form.name;
    if (c.bytes == other.bytes) return c.form.name + " with other warps";
    return fmt::format("{} of {} bytes", c.form.name, c.bytes);
}

std::string comparison(const Candidate& best, const Candidate& other)
{
    const Lead lead = leadOf(best, other);
    return fmt::format("{} errors {} {} {}, give or take {}", nameBeside(other, best),
                       best.isFinal ? "on all samples" : "held out", percent(lead.mean),
                       lead.mean < 0.0 ? "smaller" : "larger", percent(lead.error));
}

// A prior knows what materials look like, which folds of few samples do not: what is better by
// chance gives way to it.
const Candidate* leaningOnPrior(const std::vector<Candidate>& candidates, const Candidate& best)
{
    constexpr double kSure = 2.0;  // standard errors
    for (const Candidate& c : candidates) {
        if (!c.hasPrior) continue;
        const Lead lead = leadOf(best, c);
        if (lead.mean <= kSure * lead.error) return &c;
    }
    return nullptr;
}

bool isPlainlyBetter(const Candidate& a, const Candidate& b)
{
    return a.isFinal && isBetterOnAll(a, b);
}

// Of those that `best` is ahead of, by its mark or on all samples, the one of the least mark.
const Candidate* nextOf(const std::vector<Candidate>& candidates, const Candidate& best)
{
    const Candidate* next = nullptr;
    for (const Candidate& c : candidates) {
        if (&c == &best || (isBetter(c, best) && !isPlainlyBetter(best, c))) continue;
        if (!next || isBetter(c, *next)) next = &c;
    }
    return next;
}

std::string reasonFor(const std::vector<Candidate>& candidates, const Candidate& chosen,
                      const Candidate& best)
{
    std::string text = chosen.form.name + (chosen.hasPrior ? " with a prior: " : ": ");
    if (chosen.hasPrior && &chosen != &best)
        return text + "what known materials look like decides; without it, " +
               comparison(best, chosen);
    if (&chosen != &best)
        return text + "as good as " + nameBeside(best, chosen) + " on " +
               (best.isFinal ? "all samples" : "samples held out") + " and " +
               (costOf(chosen) < costOf(best) ? "cheaper" : "better on all") + "; without it, " +
               comparison(best, chosen);
    const Candidate* next = nextOf(candidates, best);
    if (!next) return text + "no other form came near it on samples held out";
    if (isPlainlyBetter(best, *next))
        return text + "better on all samples than " + nameBeside(*next, best);
    return text + "the least errors; of the next, " + comparison(best, *next);
}

// Of fits to all of many samples, those that no other is better than. All of them where there is
// none, and where trials are fitted to few samples or to a part of them.
std::vector<const Candidate*> eligible(const std::vector<Candidate>& candidates)
{
    std::vector<const Candidate*> all, unbeaten;
    for (const Candidate& c : candidates) {
        all.push_back(&c);
        const bool isBeaten =
            std::any_of(candidates.begin(), candidates.end(),
                        [&c](const Candidate& other) { return isPlainlyBetter(other, c); });
        if (!isBeaten) unbeaten.push_back(&c);
    }
    return unbeaten.empty() ? all : unbeaten;
}

}  // namespace

double Candidate::mark() const
{
    return whole ? 0.5 * meanOf(marks) + whole->mark() : meanOf(marks);
}

bool isBetter(const Candidate& a, const Candidate& b)
{
    return a.mark() < b.mark();
}

bool isBetterOnAll(const Candidate& a, const Candidate& b)
{
    constexpr double kAllowed = 1.05;
    const double above = mostAbove(errorsOnAll(b), errorsOnAll(a));
    return above > kAllowed && above >= mostAbove(errorsOnAll(a), errorsOnAll(b));
}

Lead leadOf(const Candidate& better, const Candidate& worse)
{
    FBRDF_ASSERT(better.marks.size(), ==, worse.marks.size());
    std::vector<double> differences;
    for (size_t i = 0; i < better.marks.size(); ++i)
        differences.push_back(worse.marks[i] - better.marks[i]);
    Lead lead;
    lead.mean = meanOf(differences);
    double squares = 0.0;
    for (const double d : differences) squares += (d - lead.mean) * (d - lead.mean);
    const auto count = static_cast<double>(differences.size());
    if (differences.size() > 1) lead.error = std::sqrt(squares / (count * (count - 1.0)));
    return lead;
}

Choice choose(const std::vector<Candidate>& candidates)
{
    FBRDF_ASSERT(candidates.size(), >, size_t{0});
    const std::vector<const Candidate*> pool = eligible(candidates);
    const Candidate& best =
        **std::min_element(pool.begin(), pool.end(),
                           [](const Candidate* a, const Candidate* b) { return isBetter(*a, *b); });
    const Candidate* chosen = leaningOnPrior(candidates, best);
    if (!chosen) chosen = cheapestUnbeaten(best, equalsOf(best, pool));
    return {static_cast<size_t>(chosen - candidates.data()), reasonFor(candidates, *chosen, best)};
}

}  // namespace fbrdf

#include "search/Neighbours.h"

#include "forms/FormVariants.h"
#include "forms/NamedForms.h"
#include "search/SeenErrors.h"

#include <cmath>

namespace fbrdf {
namespace {

// Least fall of the mark that pays for another warp, and for texels: half as many again. The third
// is what all texels that are taken back may cost together.
constexpr double kWorthWarp = 0.01, kWorthTexels = 0.05, kAllowed = 0.01;
// A geometric mean of errors so small that nothing is left to see: neither more texels nor other
// warps help.
constexpr double kFine = 4e-3;
// A mark can stay where it is while one of its errors rises; none may by more than this factor.
constexpr double kMostRise = 1.02;
constexpr double kSizeStep = 1.5, kWarpStep = 1.4;

// Neither texels nor warps of uniform arrays are worth a trial: they are fine, and free.
std::vector<size_t> maps(const Form& form)
{
    std::vector<size_t> indices;
    for (size_t t = 0; t < form.tables.size(); ++t)
        if (!form.tables[t].uniform) indices.push_back(t);
    return indices;
}

// The form with a larger table. Where the budget is used up, the other maps make room.
std::optional<Form> grown(const TrialRuns& runs, const Form& form, size_t table)
{
    auto result = resized(form, table, kSizeStep);
    for (const size_t other : maps(form))
        if (result && !runs.isWithin(*result) && other != table)
            if (const auto traded = resized(*result, other, 1.0 / kSizeStep)) result = traded;
    return result;
}

// True when the samples are enough for the texels of the form.
bool decides(const TrialRuns& runs, const std::optional<Form>& form)
{
    return form && formTexels(*form) * kSamplesPerTexel <= decidingSamples(runs.all());
}

bool isFine(const Candidate& candidate)
{
    return candidate.mark() < std::log(kFine);
}

bool rises(const Candidate& candidate, const Candidate& above)
{
    return mostAbove(candidate.held.errors, above.held.errors) > kMostRise;
}

// Takes the variant when it lowers the mark by `worth`, and no error rises.
bool take(TrialRuns& runs, Candidate& best, const std::optional<Form>& variant, const char* stage,
          double worth)
{
    if (!variant || isFine(best) || !runs.isWithin(*variant) || runs.isOver()) return false;
    auto next = runs.attempt(*variant, stage, best, worth);
    if (!next || rises(*next, best)) return false;
    best = std::move(*next);
    return true;
}

// A sum takes long to fit to a grid, and longer with more texels than what is left of the time.
bool hasTimeFor(const TrialRuns& runs, const Form& form)
{
    return form.terms.size() == 1 || !runs.hasPlenty() || runs.all().options.seconds <= 0.0;
}

void grow(TrialRuns& runs, Candidate& best)
{
    for (const size_t table : maps(best.form))
        for (auto next = grown(runs, best.form, table);
             decides(runs, next) && take(runs, best, next, "size", kWorthTexels);
             next = grown(runs, best.form, table)) {
        }
}

void warp(TrialRuns& runs, Candidate& best)
{
    for (const size_t table : maps(best.form))
        for (size_t axis = 0; axis < warpCount(best.form.tables[table].domain); ++axis)
            for (const double step : {kWarpStep, 1.0 / kWarpStep})
                while (
                    take(runs, best, rewarped(best.form, table, axis, step), "warp", kWorthWarp)) {
                }
}

// What giving back texels costs must not add up: every candidate is compared with the first.
void shrink(TrialRuns& runs, Candidate& best)
{
    const Candidate reference = best;
    for (const size_t table : maps(best.form))
        while (const auto smaller = resized(best.form, table, 1.0 / kSizeStep)) {
            if (runs.isOver()) return;
            auto next = runs.attempt(*smaller, "size", reference, -kAllowed);
            if (!next || rises(*next, reference)) break;
            best = std::move(*next);
        }
}

}  // namespace

void improve(TrialRuns& runs, Candidate& best)
{
    const bool sizesVary = runs.all().options.resolution == 0;
    if (sizesVary && hasTimeFor(runs, best.form)) grow(runs, best);
    warp(runs, best);
    if (sizesVary) shrink(runs, best);
}

}  // namespace fbrdf

#include "search/TrialRuns.h"

#include "data/Symmetry.h"
#include "prior/PriorUse.h"
#include "search/SeenErrors.h"

#include <fbrdf/base/Assert.h>
#include <fbrdf/base/Parallel.h>

#include <algorithm>
#include <cmath>

namespace fbrdf {
namespace {

constexpr size_t kAutoBytes = 32768;  // without --max-bytes
constexpr size_t kMaxTrials = 32, kMaxTrialsOfBest = 96;
constexpr size_t kFewRows = 20000;    // that forms are fitted to side by side
constexpr double kTrialsShare = 0.5;  // of the seconds; the rest is for the last fits
constexpr size_t kPlenty = size_t{1} << 17;

FitOptions withOneThread(FitOptions options)
{
    options.threads = 1;
    return options;
}

FitContext onOptions(const FitContext& context, const FitOptions& options)
{
    return {options,       context.dataset,      context.statistics, context.robust,
            context.folds, context.turnsHeldOut, context.prior};
}

std::vector<Sample> range(const std::vector<Sample>& samples, size_t first, size_t last)
{
    return {samples.begin() + static_cast<std::ptrdiff_t>(first),
            samples.begin() + static_cast<std::ptrdiff_t>(last)};
}

// The marks of the parts of what was held out: folds where there are several.
std::vector<double> marksOf(const HeldOut& held, const FitContext& context)
{
    std::vector<double> marks;
    const size_t count = held.samples.size();
    std::vector<size_t> ends = held.foldEnd;
    if (ends.size() < 2) {
        ends.clear();
        for (size_t part = 1; part <= kMarkParts; ++part) ends.push_back(count * part / kMarkParts);
    }
    size_t first = 0;
    for (const size_t last : ends) {
        const std::vector<Vec3f> fitted(held.fitted.begin() + static_cast<std::ptrdiff_t>(first),
                                        held.fitted.begin() + static_cast<std::ptrdiff_t>(last));
        marks.push_back(markOf(range(held.samples, first, last), fitted, context.statistics.floor,
                               context.options.metric));
        first = last;
    }
    return marks;
}

// Keeps those that could still be chosen.
void leaveBehind(std::vector<Candidate>& candidates)
{
    constexpr double kFar = 0.25;  // marks further apart than this do not change places
    constexpr double kSure = 2.0;  // standard errors
    if (candidates.empty()) return;
    const Candidate best = *std::min_element(candidates.begin(), candidates.end(), isBetter);
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [&best](const Candidate& c) {
                                        const Lead lead = leadOf(best, c);
                                        return lead.mean - kSure * lead.error > kFar;
                                    }),
                     candidates.end());
}

}  // namespace

TrialRuns::TrialRuns(const FitContext& all, const FitContext& part, bool isIsotropic,
                     std::vector<Trial>& rows)
    : all_(all),
      part_(part),
      serialOptions_(withOneThread(part.options)),
      serial_(onOptions(part, serialOptions_)),
      rows_(rows)
{
    if (!isWhole()) return;
    prior_ = priorFor(all);
    stray_.emplace(probeOf(all), all.statistics.floor, isIsotropic, all.options.threads);
}

size_t TrialRuns::budget() const
{
    return all_.options.maxBytes > 0 ? all_.options.maxBytes : kAutoBytes;
}

bool TrialRuns::hasPlenty() const
{
    return !isWhole() && all_.dataset.rows >= kPlenty;
}

// Processes that fit together must try the same forms, whatever their clocks are.
bool TrialRuns::isLate(double share, double ahead) const
{
    return all_.options.seconds > 0.0 && all_.options.ranks.count == 1 &&
           clock_.seconds() + ahead > share * all_.options.seconds;
}

bool TrialRuns::isOver() const
{
    const bool isBestOf = all_.options.form == kBestOf;
    return isLate(kTrialsShare) || rows_.size() >= (isBestOf ? kMaxTrialsOfBest : kMaxTrials);
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
    Candidate candidate;
    candidate.form = form;
    candidate.trial = rows_.size() - 1;
    candidate.bytes = trial.bytes;
    candidate.lookups = trial.lookups;
    candidate.hasPrior = stage == "prior";
    return candidate;
}

void TrialRuns::holdOutMore(const FitContext& context, Candidate& candidate, int folds)
{
    context.options.watch.say("trying " + candidate.form.name);
    const Clock clock;
    HeldOut& held = candidate.held;
    holdOut(contextFor(context, candidate), candidate.form,
            context.options.smoothness.value_or(held.solution.smoothness), folds, held);
    candidate.marks = marksOf(held, context);
    rows_[candidate.trial].seconds += clock.seconds();
}

FitContext TrialRuns::contextFor(const FitContext& context, const Candidate& candidate) const
{
    FitContext result = context;
    if (candidate.hasPrior) result.prior = prior_;
    return result;
}

void TrialRuns::complete(const FitContext& context, Candidate& candidate)
{
    holdOutMore(context, candidate, context.folds);
    if (!stray_) return;
    const Clock clock;
    candidate.whole = fitRestrained(contextFor(context, candidate), candidate.form, *stray_);
    rows_[candidate.trial].seconds += clock.seconds();
}

void TrialRuns::record(const Candidate& candidate)
{
    Trial& trial = rows_[candidate.trial];
    trial.heldOut = candidate.held.errors;
    trial.score = std::exp(candidate.mark());
}

bool TrialRuns::isSideBySide() const
{
    return part_.dataset.rows < kFewRows && all_.options.ranks.count == 1;
}

template <class Task>
std::vector<Candidate> TrialRuns::untilOver(std::vector<Candidate> candidates, const Task& task)
{
    std::vector<char> isDone(candidates.size(), false);
    parallelTasks(candidates.size(), isSideBySide() ? all_.options.threads : 1, [&](size_t i) {
        if (i > 0 && isOver()) return;
        task(isSideBySide() ? serial_ : part_, candidates[i]);
        isDone[i] = true;
    });
    std::vector<Candidate> done;
    for (size_t i = 0; i < candidates.size(); ++i) {
        if (!isDone[i]) continue;
        record(candidates[i]);
        done.push_back(std::move(candidates[i]));
    }
    return done;
}

std::vector<Candidate> TrialRuns::tryAll(std::vector<Candidate> candidates)
{
    candidates =
        untilOver(std::move(candidates), [this](const FitContext& context, Candidate& candidate) {
            holdOutMore(context, candidate, 1);
        });
    // With few samples one fold shows too little to leave a form behind.
    if (part_.folds == 1) leaveBehind(candidates);
    std::sort(candidates.begin(), candidates.end(), isBetter);  // the most promising first
    return untilOver(
        std::move(candidates),
        [this](const FitContext& context, Candidate& candidate) { complete(context, candidate); });
}

void TrialRuns::fitWhole(Candidate& candidate)
{
    all_.options.watch.say("fitting " + candidate.form.name + " to all samples");
    const Clock clock;
    Restrained& whole = candidate.whole.emplace();
    whole.fitted = fitForm(all_, candidate.form, &candidate.held.solution);
    HeldOut on;
    on.samples = probeOf(all_);
    on.fitted =
        evaluateAt(whole.fitted.material, part_.turnsHeldOut ? turned(on.samples) : on.samples,
                   all_.options.threads);
    whole.all = sampleErrors(on.samples, on.fitted, all_.statistics.floor);
    whole.allMark = markOf(on.samples, on.fitted, all_.statistics.floor, all_.options.metric);
    candidate.marks = marksOf(on, all_);
    candidate.isFinal = true;
    rows_[candidate.trial].seconds += clock.seconds();
}

std::optional<Candidate> TrialRuns::attempt(const Form& variant, const std::string& stage,
                                            const Candidate& reference, double gain)
{
    Candidate next = added(variant, stage);
    next.held.solution.smoothness = reference.held.solution.smoothness;
    complete(part_, next);
    record(next);
    const Lead lead = leadOf(next, reference);
    const bool isSure = gain <= 0.0 || !lead.isNoise();
    if (!isSure || lead.mean < gain || next.mark() > reference.mark() - gain) return std::nullopt;
    return next;
}

}  // namespace fbrdf

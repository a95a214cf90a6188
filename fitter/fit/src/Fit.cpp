#include "Bake.h"
#include "NamedForms.h"
#include "Solve.h"

#include <fbrdf/brdf/Error.h>
#include <fbrdf/brdf/HalfDifference.h>
#include <fbrdf/fit/Fit.h>
#include <fbrdf/fit/SampleSets.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace fbrdf {
namespace {

constexpr size_t kFunctionSamples = 131072;  // taken from a source that is only a function
constexpr size_t kTestSamples = 65536;       // interfaces.md: the uniform test set
constexpr size_t kProbeSamples = 200000;     // that traits and sample errors are taken from
constexpr size_t kTrialSamples = 32768;      // that auto compares forms on
constexpr size_t kSmallSet = 20000;          // below: all five folds are held out in turn
constexpr size_t kAutoBytes = 32768;         // of auto without --max-bytes
// auto keeps the smaller of two materials unless the larger is better by this: a byte must earn its
// place.
constexpr double kWorthwhile = 0.01;

class Clock {
public:
    double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The data of one fit, and what is the same for every form tried on it.
struct Job {
    const FitOptions& options;
    Feed feed;
    DataTraits traits;
    bool robust = false;
    int folds = 1;
};

SolveOptions solveOptions(const Job& job)
{
    SolveOptions options;
    options.smoothness = job.options.smoothness.value_or(0.0);
    options.metric = job.options.metric;
    options.robust = job.robust;
    options.folds = job.folds;
    return options;
}

LeastSquaresOptions problemOptions(const Job& job)
{
    LeastSquaresOptions options;
    options.sharedShape = job.options.sharedShape;
    options.cache = job.options.cache.get();
    options.ranks = job.options.ranks;
    return options;
}

Feed readFeed(const Source& source, const FitOptions& options)
{
    Feed feed = makeFeed(source, kFunctionSamples, options.seed, options.threads);
    if (feed.rows == 0)
        throw Error(ErrorKind::fit, source.name, "found no samples, expected at least one");
    return feed;
}

Job makeJob(Feed feed, const FitOptions& options)
{
    Job job{options, std::move(feed), {}, false, 1};
    const auto probe = someSamples(job.feed, kNoFold, kProbeSamples, options.seed);
    job.traits = traitsOf(probe, job.feed.exact);
    job.robust = options.robust && !job.feed.exact;
    job.folds = job.feed.rows < kSmallSet ? kFolds : 1;
    return job;
}

// Errors on samples that took no part: each fold in turn is left out of a fit of its own.
SampleErrors heldOutErrors(const Job& job, const Form& form, double smoothness, int folds)
{
    const LeastSquares problem(form, job.feed, job.traits, job.options.seed, job.options.threads,
                               problemOptions(job));
    std::vector<Sample> held;
    std::vector<Vec3f> fitted;
    for (int fold = 0; fold < folds; ++fold) {
        SolveOptions options = solveOptions(job);
        options.smoothness = smoothness;
        options.excludedFold = fold;
        const Material material =
            bake(form, problem.layout(), solve(problem, options).x, job.options.storage);
        const auto part = someSamples(job.feed, fold, kProbeSamples, job.options.seed);
        const auto values = evaluateAt(material, part, job.options.threads);
        held.insert(held.end(), part.begin(), part.end());
        fitted.insert(fitted.end(), values.begin(), values.end());
    }
    if (held.empty()) return {};
    return sampleErrors(held, fitted, job.traits.floor);
}

double scoreOf(const SampleErrors& errors, Metric metric)
{
    switch (metric) {
        case Metric::cubeRoot: return errors.cubeRootRms;
        case Metric::log1p: return errors.nbrdfLoss;
        default: return errors.logMedian;
    }
}

// A function is isotropic when turning pairs about the normal changes nothing.
bool isIsotropicSource(const Source& source)
{
    if (source.isotropic) return true;
    if (!source.evaluate) return false;
    constexpr double kSame = 1e-3;  // relative; below what any material of ours resolves
    double largest = 0.0, difference = 0.0;
    for (const auto& pair : uniformPairs(512, 17)) {
        HalfDifference turned = halfDifferenceFromPair(pair);
        turned.phi_h += 1.0;
        const auto other = pairFromHalfDifference(turned);
        const Vec3d a = source.evaluate(pair.wo, pair.wi), b = source.evaluate(other.wo, other.wi);
        largest = std::max(largest, a.x + a.y + a.z);
        difference = std::max(difference, glm::length(a - b) / (a.x + a.y + a.z + 1e-6));
    }
    return difference < kSame || largest == 0.0;
}

std::vector<std::string> candidates(const Source& source)
{
    if (isIsotropicSource(source)) return {"hdio", "io+hdio", "pqpr"};
    return {"hdio", "pqp", "pqpr", "io+pqpr"};
}

// The data that forms are compared on: all of it, or a part that is large enough to tell them
// apart.
Job trialJob(const Job& job, const std::vector<Sample>& part)
{
    Job trial = job;
    if (part.empty()) return trial;
    trial.feed = heldFeed(part);
    trial.feed.exact = job.feed.exact;
    return trial;
}

Form searchForm(const Source& source, const Job& job, std::vector<Trial>& trials)
{
    const size_t budget = job.options.maxBytes > 0 ? job.options.maxBytes : kAutoBytes;
    std::vector<Sample> part;
    if (job.feed.rows > kTrialSamples)
        part = someSamples(job.feed, kNoFold, kTrialSamples, job.options.seed);
    const Job trial = trialJob(job, part);
    std::vector<Form> forms;
    for (const std::string& name : candidates(source)) {
        const Clock clock;
        Form form;
        try {
            form = job.options.resolution > 0
                       ? makeForm(name, job.options.resolution)
                       : makeFormFor(name, job.feed.rows, budget, job.options.storage);
        } catch (const Error&) {
            continue;  // even its smallest size is over the budget
        }
        if (formBytes(form, job.options.storage) > budget) continue;
        const SampleErrors errors =
            heldOutErrors(trial, form, job.options.smoothness.value_or(0.0), 1);
        Trial t;
        t.form = name;
        t.description = describe(form);
        t.bytes = formBytes(form, job.options.storage);
        t.lookups = lookupsPerLight(form);
        t.seconds = clock.seconds();
        t.heldOut = errors;
        t.score = scoreOf(errors, job.options.metric);
        trials.push_back(t);
        forms.push_back(form);
    }
    if (forms.empty())
        throw Error(ErrorKind::usage, "max-bytes",
                    "found " + std::to_string(budget) + ", expected room for a form");
    size_t best = 0;
    for (size_t i = 1; i < forms.size(); ++i) {
        const bool larger = trials[i].bytes > trials[best].bytes;
        if (trials[i].score < trials[best].score * (larger ? 1.0 - kWorthwhile : 1.0)) best = i;
    }
    trials[best].chosen = true;
    return forms[best];
}

void checkOptions(const FitOptions& options)
{
    if (options.lookups < 1)
        throw Error(ErrorKind::usage, "lookups",
                    "found " + std::to_string(options.lookups) + ", expected at least 1");
    if (options.smoothness && !(*options.smoothness > 0.0))
        throw Error(ErrorKind::usage, "smoothness",
                    "found " + std::to_string(*options.smoothness) + ", expected above 0");
}

}  // namespace

FitResult fitMaterial(const Source& source, const FitOptions& options)
{
    checkOptions(options);
    const Clock readClock;
    Feed feed = readFeed(source, options);
    FitResult result;
    FitSummary& summary = result.summary;
    summary.readSeconds = readClock.seconds();
    const Clock clock;
    const Job job = makeJob(std::move(feed), options);
    const Form form = options.form == "auto"   ? searchForm(source, job, summary.trials)
                      : options.resolution > 0 ? makeForm(options.form, options.resolution)
                                               : makeFormFor(options.form, job.feed.rows,
                                                             options.maxBytes, options.storage);
    if (options.maxBytes > 0 && formBytes(form, options.storage) > options.maxBytes)
        throw Error(ErrorKind::usage, "max-bytes",
                    "found " + std::to_string(options.maxBytes) + ", expected at least " +
                        std::to_string(formBytes(form, options.storage)) +
                        " for this form and resolution");
    const LeastSquares problem(form, job.feed, job.traits, options.seed, options.threads,
                               problemOptions(job));
    const Solution solution = solve(problem, solveOptions(job));
    result.material = bake(form, problem.layout(), solution.x, options.storage);
    result.material.name = source.name;
    summary.seconds = clock.seconds();
    summary.noiseFloor = job.traits.floor;
    summary.smoothness = solution.smoothness;
    const auto probe = someSamples(job.feed, kNoFold, kProbeSamples, options.seed);
    summary.all =
        sampleErrors(probe, evaluateAt(result.material, probe, options.threads), job.traits.floor);
    summary.used = job.feed.rows;
    for (const Sample& s : probe)
        for (int c = 0; c < 3; ++c)
            if (!(s.f[c] > job.traits.floor[c])) ++summary.belowFloor;
    if (!options.heldOut) return result;
    if (job.feed.exact) {
        const auto test = samplesAt(source, uniformPairs(kTestSamples, 0), options.threads);
        summary.heldOut = sampleErrors(test, evaluateAt(result.material, test, options.threads),
                                       job.traits.floor);
    } else {
        summary.folds = job.folds;
        summary.heldOut = heldOutErrors(job, form, solution.smoothness, job.folds);
    }
    return result;
}

}  // namespace fbrdf

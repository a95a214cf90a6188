#include "FitContext.h"

#include <fbrdf/base/Assert.h>

#include "data/Symmetry.h"
#include "forms/NamedForms.h"
#include "Quantize.h"
#include "TexelWeights.h"
#include "Unsampled.h"

#include <fbrdf/base/Error.h>
#include <fbrdf/metrics/SampleSets.h>

#include <algorithm>

namespace fbrdf {
namespace {

constexpr size_t kFunctionSamples = 131072;  // drawn from a source that is only a function
constexpr size_t kProbeSamples = 200000;     // that sample errors are computed on
constexpr size_t kSmallSet = 5000;           // below: all five folds are held out in turn

// The cost of the solution with the options of the job's last steps; of a stream on a part of it.
double costOf(const LeastSquares& problem, const Job& job, const Solution& solution)
{
    constexpr size_t kStreamRows = 262144;
    StepOptions options;
    options.metric = job.options.metric;
    options.robust = job.robust;
    const auto at = [&](const LeastSquares& of) {
        return cost(of, solution.x, options, residualScale(of, solution.x, options));
    };
    return problem.isHeld() ? at(problem) : at(problem.thinned(kStreamRows, kNoFold));
}

}  // namespace

Feed readFeed(const Source& source, const FitOptions& options)
{
    Feed feed = makeFeed(source, kFunctionSamples, options.seed, options.threads);
    if (feed.rows == 0)
        throw Error(ErrorKind::fit, source.name, "found no samples, expected at least one");
    return feed;
}

Job makeJob(Feed feed, const FitOptions& options, const std::string& source)
{
    Job job{options, std::move(feed), {}, false, 1, false};
    job.traits = traitsOf(job.feed, {options.seed, options.threads, options.ranks}, source);
    job.robust = options.robust && !job.feed.exact;
    job.folds = job.feed.rows < kSmallSet ? kFolds : 1;
    return job;
}

size_t decidingSamples(const Job& job)
{
    return job.traits.floor == Vec3f(0.0f) ? 2 * job.feed.rows : job.feed.rows;
}

Job partOf(const Job& job, std::vector<Sample> part)
{
    Job result = job;
    if (part.empty()) return result;
    result.feed = heldFeed(std::move(part));
    result.feed.exact = job.feed.exact;
    return result;
}

size_t bytesOf(const Job& job, const Form& form)
{
    return formBytes(form, job.options.storage) / (job.options.sharedShape ? 3 : 1);
}

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
    options.limits = job.options.solver;
    options.cache = job.options.cache.get();
    options.ranks = job.options.ranks;
    return options;
}

std::vector<Sample> probeOf(const Job& job, const FoldChoice& choice)
{
    return someSamples(job.feed, choice, kProbeSamples, job.options.seed, job.options.threads);
}

Fitted fitForm(const Job& job, const Form& form)
{
    const LeastSquares problem(form, job.feed, job.traits, job.options.seed, job.options.threads,
                               problemOptions(job));
    Solution solution = solve(problem, solveOptions(job));
    const std::vector<double> support = supportOf(problem);
    extendHue(problem, support, solution.x);
    Fitted fitted{bake(form, problem.layout(), solution.x, job.options.storage),
                  solution.smoothness,
                  solution.summary,
                  {}};
    fitted.solver.cost = costOf(problem, job, solution);
    markUnsupported(fitted.material, problem.layout(), support);
    return fitted;
}

SampleErrors heldOutErrors(const Source& source, const Job& job, const Fitted& fitted)
{
    if (fitted.heldOut) return *fitted.heldOut;
    if (!job.feed.exact) {
        HeldOut held;
        holdOut(job, fitted.material.form, fitted.smoothness, job.folds, held);
        return held.errors;
    }
    const auto test = samplesAt(source, uniformPairs(kUniformTestPairs, 0), job.options.threads);
    return sampleErrors(test, evaluateAt(fitted.material, test, job.options.threads),
                        job.traits.floor);
}

void holdOut(const Job& job, const Form& form, double smoothness, int folds, HeldOut& held)
{
    FBRDF_ASSERT(folds, <=, kFolds);
    if (held.folds >= folds) return;
    const LeastSquares problem(form, job.feed, job.traits, job.options.seed, job.options.threads,
                               problemOptions(job));
    const std::vector<double> support = supportOf(problem);
    for (; held.folds < folds; ++held.folds) {
        SolveOptions options = solveOptions(job);
        options.smoothness = smoothness;
        options.excludedFold = held.folds;
        Solution solution = solve(problem, options);
        extendHue(problem, support, solution.x);
        held.smoothness = solution.smoothness;
        const Material material = bake(form, problem.layout(), solution.x, job.options.storage);
        const auto part = probeOf(job, FoldChoice::onlyOf(held.folds));
        const auto values =
            evaluateAt(material, job.turnsHeldOut ? turned(part) : part, job.options.threads);
        held.samples.insert(held.samples.end(), part.begin(), part.end());
        held.fitted.insert(held.fitted.end(), values.begin(), values.end());
        held.foldEnd.push_back(held.samples.size());
    }
    if (!held.samples.empty())
        held.errors = sampleErrors(held.samples, held.fitted, job.traits.floor);
}

}  // namespace fbrdf
